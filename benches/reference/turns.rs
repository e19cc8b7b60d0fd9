//! Timing in turns: whatever else the machine does falls on all that is compared alike.

use std::time::Instant;

/// Turns, and how long a turn of a small thing is.
pub(crate) const TURNS: usize = 301;
const TURN: f64 = 2e-5;

/// Something done a number of times.
pub(crate) type Work<'a> = &'a mut dyn FnMut(u32);

/// Nanoseconds for one call of each, in turns: medians.
pub(crate) fn in_turns<const N: usize>(turns: usize, works: [Work<'_>; N]) -> [f64; N] {
    let mut times = vec![Vec::with_capacity(turns); N];
    let mut counts = [1_u32; N];
    let mut works = works;
    for (work, count) in works.iter_mut().zip(&mut counts) {
        work(1);
        let begun = Instant::now();
        work(1);
        let once = begun.elapsed().as_secs_f64().max(1e-9);
        *count = (TURN / once).ceil().clamp(1.0, 1e4) as u32;
    }
    for _ in 0..turns {
        for ((work, count), times) in works.iter_mut().zip(counts).zip(&mut times) {
            let begun = Instant::now();
            work(count);
            times.push(begun.elapsed().as_secs_f64() / f64::from(count));
        }
    }
    std::array::from_fn(|i| {
        times[i].sort_by(f64::total_cmp);
        1e9 * times[i][turns / 2]
    })
}

/// Calls a thing as often as is asked.
macro_rules! repeated {
    ($thing:expr) => {
        &mut |count| {
            for _ in 0..count {
                let _ = std::hint::black_box($thing);
            }
        }
    };
}

pub(crate) use repeated;
