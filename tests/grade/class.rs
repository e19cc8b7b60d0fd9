//! A class of which the truth is known: made of random routes, notations and orders of terms, and of
//! random mistakes, some of them carried on.

use super::{KEY, LAW, key};
use polhode::grade::{Key, Work, mark};
use polhode::notation::document::Format;

/// How many are made, unless `POLHODE_CLASS` says another number.
const STUDENTS: u64 = 400;

fn students() -> u64 {
    let asked = std::env::var("POLHODE_CLASS").ok();
    asked.and_then(|n| n.parse().ok()).unwrap_or(STUDENTS)
}

/// What a student believes of each term: 1 is right.
struct Beliefs {
    /// The factor of ω × L in the moment.
    turn: i64,
    /// The factors of I_xx ω_x, I_xz ω_z, I_yy ω_y, I_zz ω_z, I_xz ω_x in the momentum.
    momentum: [i64; 5],
    /// The factor of the last term of the answer by a slip of its own.
    answer: i64,
}

/// A random sequence (splitmix64).
struct Random(u64);

impl Random {
    fn below(&mut self, n: u64) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        (z ^ (z >> 31)) % n
    }

    /// Right mostly, else a sign or a factor.
    fn belief(&mut self) -> i64 {
        [1, 1, 1, 1, 1, 1, 1, 1, -1, 2][self.below(10) as usize]
    }
}

/// A sum in a random order.
fn sum(random: &mut Random, mut terms: Vec<(i64, &str)>) -> String {
    let mut text = String::new();
    while !terms.is_empty() {
        let at = random.below(terms.len() as u64) as usize;
        let (factor, term) = terms.remove(at);
        let sign = if factor < 0 {
            "-"
        } else if text.is_empty() {
            ""
        } else {
            "+"
        };
        let size = match factor.abs() {
            1 => String::new(),
            size => size.to_string(),
        };
        text.push_str(&format!(" {sign} {size}{term}"));
    }
    text
}

/// How a student writes, and by which route.
struct Manner {
    vector: &'static str,
    /// The rates of ω_x and ω_z.
    rates: [&'static str; 2],
    /// What stands before and behind a display.
    display: [&'static str; 2],
    /// Whether the component of the law is written, and behind the momentum.
    component: bool,
    momentum_first: bool,
    /// Whether the momentum is one line of columns.
    columns: bool,
    /// Whether the answer goes on from the component in one chain.
    chain: bool,
}

impl Manner {
    fn of(random: &mut Random, own: &Beliefs) -> Self {
        let rates = [
            [r"\dot\omega_x", r"\dot\omega_z"],
            [r"\dot{\omega}_x", r"\dot{\omega}_z"],
            [r"\frac{d\omega_x}{dt}", r"\frac{d\omega_z}{dt}"],
            [
                r"\frac{\mathrm{d}\omega_x}{\mathrm{d}t}",
                r"\frac{\mathrm{d}\omega_z}{\mathrm{d}t}",
            ],
        ];
        let display = [["$$", "$$"], ["\n\n$$\n", "\n$$\n\n"], ["\\[", "\\]"]];
        Self {
            vector: [r"\vec", r"\mathbf", r"\boldsymbol"][random.below(3) as usize],
            rates: rates[random.below(4) as usize],
            display: display[random.below(3) as usize],
            // What is implied by the law need not be written; what is believed wrongly is.
            component: own.turn != 1 || random.below(4) > 0,
            momentum_first: random.below(3) == 0,
            columns: random.below(4) == 0,
            chain: own.turn == 1 && random.below(4) == 0,
        }
    }

    fn shown(&self, formula: &str) -> String {
        let [open, close] = self.display;
        format!("{open}{formula}{close}")
    }

    fn momentum(&self, random: &mut Random, own: &Beliefs) -> String {
        let [xx, xz, yy, zz, zx] = own.momentum;
        let x = vec![(xx, r"I_{xx}\omega_x"), (-xz, r"I_{xz}\omega_z")];
        let z = vec![(zz, r"I_{zz}\omega_z"), (-zx, r"I_{xz}\omega_x")];
        let sums = [
            sum(random, x),
            sum(random, vec![(yy, r"I_{yy}\omega_y")]),
            sum(random, z),
        ];
        let [x, y, z] = sums;
        match self.columns {
            true => self.shown(&format!(
                "\\begin{{bmatrix}} L_x \\\\ L_y \\\\ L_z \\end{{bmatrix}} = \
                 \\begin{{bmatrix}} {x} \\\\ {y} \\\\ {z} \\end{{bmatrix}}"
            )),
            false => [("x", x), ("y", y), ("z", z)]
                .map(|(axis, side)| self.shown(&format!("L_{axis} = {side}")))
                .join(" "),
        }
    }

    fn answer(&self, random: &mut Random, own: &Beliefs) -> String {
        let [xx, xz, yy, zz, zx] = own.momentum;
        let (rate_x, rate_z) = (
            format!("I_{{xx}}{}", self.rates[0]),
            format!("I_{{xz}}{}", self.rates[1]),
        );
        sum(
            random,
            vec![
                (xx, &rate_x),
                (-xz, &rate_z),
                (own.turn * zz, r"I_{zz}\omega_y\omega_z"),
                (-own.turn * zx, r"I_{xz}\omega_x\omega_y"),
                (-own.turn * yy * own.answer, r"I_{yy}\omega_y\omega_z"),
            ],
        )
    }
}

fn submission(random: &mut Random, own: &Beliefs) -> String {
    let manner = Manner::of(random, own);
    let terms = vec![
        (1, r"\dot L_x"),
        (own.turn, r"\omega_y L_z"),
        (-own.turn, r"\omega_z L_y"),
    ];
    let component = sum(random, terms);
    let mut parts = vec![];
    if manner.component {
        parts.push(format!(
            "Hence {}",
            manner.shown(&format!("M_x = {component}"))
        ));
    }
    let momentum = format!("Further {}", manner.momentum(random, own));
    let at = if manner.momentum_first {
        0
    } else {
        parts.len()
    };
    parts.insert(at, momentum);
    let answer = manner.answer(random, own);
    let chain = if manner.chain {
        format!("{component} = ")
    } else {
        String::new()
    };
    parts.push(format!(
        "so {}",
        manner.shown(&format!("M_x = {chain}{answer}"))
    ));
    format!("{LAW}{}", parts.join(" ")).replace(r"\vec", manner.vector)
}

/// The outcomes that a careful marker gives.
fn truth(own: &Beliefs) -> [&'static str; 4] {
    let component = if own.turn == 1 { "full" } else { "none" };
    let right = own.momentum == [1; 5];
    let momentum = if right { "full" } else { "none" };
    let answer = match (right && own.turn == 1, own.answer) {
        (true, 1) => "full",
        (false, 1) => "follow-through",
        _ => "none",
    };
    ["full", component, momentum, answer]
}

/// What came of some students: right, waiting, and what is wrong.
/// One student, and what is handed in.
fn student(seed: u64) -> (Beliefs, Work) {
    let mut random = Random(seed);
    let own = Beliefs {
        turn: random.belief(),
        momentum: [(); 5].map(|()| random.belief()),
        answer: random.belief(),
    };
    let text = submission(&mut random, &own);
    (own, Work::of_text("s", "s.md", Format::Markdown, &text))
}

#[derive(Default)]
struct Tally {
    right: usize,
    waiting: Vec<String>,
    wrong: Vec<String>,
}

impl Tally {
    fn of(key: &Key, seeds: std::ops::Range<u64>) -> Self {
        let mut tally = Self::default();
        for seed in seeds {
            let (own, work) = student(seed);
            let text = &work.texts[0].text;
            let graded = mark(key, &work);
            for (milestone, expected) in graded.milestones.iter().zip(truth(&own)) {
                let (label, why) = (&milestone.label, &milestone.reason);
                match milestone.outcome.name() {
                    found if found == expected => tally.right += 1,
                    "human" => tally.waiting.push(format!("{label}: {why}\n{text}")),
                    found => tally.wrong.push(format!(
                        "{label} is {found} and not {expected}: {why}\n{text}"
                    )),
                }
            }
        }
        tally
    }
}

#[test]
fn no_wrong_mark_is_given_in_silence() {
    let key = key(KEY);
    let start = std::time::Instant::now();
    let students = students();
    let halves = [0..students / 2, students / 2..students].map(|seeds| {
        let key = key.clone();
        std::thread::spawn(move || Tally::of(&key, seeds))
    });
    let mut all = Tally::default();
    for half in halves {
        let tally = half.join().expect("marked");
        all.right += tally.right;
        all.waiting.extend(tally.waiting);
        all.wrong.extend(tally.wrong);
    }
    let (right, waiting, wrong) = (all.right, all.waiting.len(), all.wrong.len());
    println!(
        "{students} submissions in {:.0} s: {right} milestones marked right, {waiting} wait for a person, {wrong} wrong",
        start.elapsed().as_secs_f64()
    );
    all.waiting
        .iter()
        .take(3)
        .for_each(|one| println!("waits, {one}\n"));
    assert!(all.wrong.is_empty(), "{wrong} wrong; {}", all.wrong[0]);
    assert!(
        right * 100 >= (right + waiting) * 99,
        "{right} right, {waiting} wait"
    );
}

#[test]
fn what_is_said_of_a_student_does_not_hang_on_who_was_marked_before() {
    let alone = |seed: u64| mark(&key(KEY), &student(seed).1);
    let alone: Vec<_> = (0..40).map(alone).collect();
    let (forwards, backwards) = (key(KEY), key(KEY));
    for seed in 0..40 {
        let other = 39 - seed;
        for (key, seed) in [(&forwards, seed), (&backwards, other)] {
            let graded = mark(key, &student(seed).1);
            assert_eq!(graded, alone[seed as usize], "student {seed}");
        }
    }
}
