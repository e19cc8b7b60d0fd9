//! Marking classes of 100 to 100 000 submissions of twenty lines, on one thread, with every output: how many a second of the
//! processor and of the clock, and how much memory. In a uniform class all write nearly the same; in a varied one no two do:
//! of the 20 000 lines of its first thousand 6 000 are different ones. `POLHODE_BENCH_MOST` says up to which size; a
//! class of 100 000 takes minutes and 5 GB on the disk.
//!
//! Some file systems pass over the places of files that were deleted in the last minutes, one by one, for each new file: that
//! can take longer than the marking. So nothing is deleted before all is measured, and `TMPDIR` may name a folder in memory.

use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

mod grade {
    pub(crate) mod varied;
}

const KEY: &str = include_str!("../examples/grading/key.md");
const SIZES: [usize; 4] = [100, 1_000, 10_000, 100_000];

/// Up to which size, where nothing else is said.
const MOST: usize = 10_000;

/// Twenty lines: the example's derivation with steps between its milestones, and a slip in every third.
fn submission(number: usize) -> String {
    let sign = if number.is_multiple_of(3) { "+" } else { "-" };
    let turned = if number.is_multiple_of(3) { "-" } else { "+" };
    let mut text = String::from(
        "$$\\vec M = (\\dot{\\vec L})_{xyz} + \\vec\\omega\\times\\vec L$$\n\
         $$M_x = \\dot L_x + \\omega_y L_z - \\omega_z L_y$$\n\
         $$M_y = \\dot L_y + \\omega_z L_x - \\omega_x L_z$$\n\
         $$M_z = \\dot L_z + \\omega_x L_y - \\omega_y L_x$$\n",
    );
    text.push_str(&format!(
        "$$L_x = I_{{xx}}\\omega_x - I_{{xz}}\\omega_z$$\n$$L_y = I_{{yy}}\\omega_y$$\n\
         $$L_z = I_{{zz}}\\omega_z {sign} I_{{xz}}\\omega_x$$\n\
         $$\\dot L_x = I_{{xx}}\\dot\\omega_x - I_{{xz}}\\dot\\omega_z$$\n$$\\dot L_y = I_{{yy}}\\dot\\omega_y$$\n\
         $$M_x = \\dot L_x + \\omega_y(I_{{zz}}\\omega_z {sign} I_{{xz}}\\omega_x) - \\omega_z I_{{yy}}\\omega_y$$\n"
    ));
    let steps = [
        "M_x - \\dot L_x = \\omega_y L_z - \\omega_z L_y",
        "M_y - \\dot L_y = \\omega_z L_x - \\omega_x L_z",
        "\\omega_z L_y = I_{yy}\\omega_y\\omega_z",
        "2 L_y = 2 I_{yy}\\omega_y",
        "L_y\\omega_x = I_{yy}\\omega_x\\omega_y",
        "L_x\\omega_y = I_{xx}\\omega_x\\omega_y - I_{xz}\\omega_y\\omega_z",
        "L_x\\omega_z = I_{xx}\\omega_x\\omega_z - I_{xz}\\omega_z^2",
        "\\omega_x L_x = I_{xx}\\omega_x^2 - I_{xz}\\omega_x\\omega_z",
        "L_y\\omega_y = I_{yy}\\omega_y^2",
    ];
    steps
        .iter()
        .for_each(|step| text.push_str(&format!("$${step}$$\n")));
    text.push_str(&format!(
        "$$M_x = I_{{xx}}\\dot\\omega_x - I_{{xz}}\\dot\\omega_z {turned_sign} I_{{xz}}\\omega_x\\omega_y \
         + (I_{{zz}} - I_{{yy}})\\omega_y\\omega_z$$\n",
        turned_sign = if turned == "+" { "-" } else { "+" }
    ));
    // No two are alike.
    text.push_str(&format!("\nThis is the work of number {number}.\n"));
    text
}

/// What one run took: seconds of the clock and of the processor, and megabytes.
struct Taken {
    clock: f64,
    processor: f64,
    peak: u64,
}

/// Ticks of the processor in a second, as Linux counts them for programs.
const TICKS: f64 = 100.0;

/// The seconds of the processor that a process took so far.
fn processor_seconds(id: u32) -> Option<f64> {
    let stat = fs::read_to_string(format!("/proc/{id}/stat")).ok()?;
    // Behind the name: the state, ten numbers, and the ticks in the program and in the system.
    let mut fields = stat.rsplit_once(')')?.1.split_whitespace().skip(11);
    let mut ticks = || fields.next()?.parse::<f64>().ok();
    Some((ticks()? + ticks()?) / TICKS)
}

fn run(folder: &Path) -> Taken {
    let path = |name: &str| folder.join(name);
    let start = Instant::now();
    let mut child = Command::new(env!("CARGO_BIN_EXE_polhode"))
        .arg("grade")
        .args([path("key.md"), path("work")])
        .arg("--out")
        .arg(path("out"))
        .args(["--threads", "1", "--feedback-format", "html,md,json"])
        .arg("--gradebook=csv,jsonl,gradescope,prairielearn,moodle,canvas,coderunner,points")
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .expect("the command runs");
    let (mut peak, mut processor) = (0, 0.0);
    while child.try_wait().expect("waited for").is_none() {
        let status = fs::read_to_string(format!("/proc/{}/status", child.id())).unwrap_or_default();
        let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
        let kilobytes = line.and_then(|line| line.split_whitespace().next()?.parse::<u64>().ok());
        peak = peak.max(kilobytes.unwrap_or(0));
        processor = processor_seconds(child.id()).map_or(processor, |now| now.max(processor));
        std::thread::sleep(Duration::from_millis(5));
    }
    Taken {
        clock: start.elapsed().as_secs_f64(),
        processor,
        peak: peak >> 10,
    }
}

/// Marks classes of all sizes, and returns their folders.
fn measure(name: &str, submission: impl Fn(usize) -> String) -> Vec<tempfile::TempDir> {
    let most = std::env::var("POLHODE_BENCH_MOST").ok();
    let most: usize = most.and_then(|n| n.parse().ok()).unwrap_or(MOST);
    let sizes = SIZES.into_iter();
    let sizes = sizes.filter(|size| *size <= most);
    let folders = sizes.map(|size| {
        let folder = tempfile::tempdir().expect("a folder");
        fs::create_dir(folder.path().join("work")).expect("made");
        fs::write(folder.path().join("key.md"), KEY).expect("written");
        for number in 0..size {
            let path = folder.path().join(format!("work/s{number:05}.md"));
            fs::write(path, submission(number)).expect("written");
        }
        let Taken {
            clock,
            processor,
            peak,
        } = run(folder.path());
        let [of_processor, of_clock] = [processor, clock].map(|seconds| size as f64 / seconds);
        println!("{name:<8} {size:>11} {of_processor:>15.0} {of_clock:>10.0} {peak:>9}");
        folder
    });
    folders.collect()
}

fn main() {
    println!("class    submissions   a CPU second   a second   peak MB");
    let folders = [
        measure("uniform", submission),
        measure("varied", grade::varied::submission),
    ];
    drop(folders);
}
