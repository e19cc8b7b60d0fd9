//! A class of which the truth is known: made of random orders of terms and of random mistakes, some of them carried on.

use super::{KEY, LAW, key};
use polhode::grade::{Work, mark};
use polhode::notation::document::Format;

/// How many are made.
const STUDENTS: u64 = 150;

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

fn submission(random: &mut Random, own: &Beliefs) -> String {
    let [xx, xz, yy, zz, zx] = own.momentum;
    let component = sum(
        random,
        vec![
            (1, r"\dot L_x"),
            (own.turn, r"\omega_y L_z"),
            (-own.turn, r"\omega_z L_y"),
        ],
    );
    let l_x = sum(
        random,
        vec![(xx, r"I_{xx}\omega_x"), (-xz, r"I_{xz}\omega_z")],
    );
    let l_y = sum(random, vec![(yy, r"I_{yy}\omega_y")]);
    let l_z = sum(
        random,
        vec![(zz, r"I_{zz}\omega_z"), (-zx, r"I_{xz}\omega_x")],
    );
    let answer = sum(
        random,
        vec![
            (xx, r"I_{xx}\dot\omega_x"),
            (-xz, r"I_{xz}\dot\omega_z"),
            (own.turn * zz, r"I_{zz}\omega_y\omega_z"),
            (-own.turn * zx, r"I_{xz}\omega_x\omega_y"),
            (-own.turn * yy * own.answer, r"I_{yy}\omega_y\omega_z"),
        ],
    );
    format!(
        "{LAW}Hence $$M_x = {component}$$ Further $$L_x = {l_x}$$ $$L_y = {l_y}$$ $$L_z = {l_z}$$ so $$M_x = {answer}$$"
    )
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

#[test]
fn no_wrong_mark_is_given_in_silence() {
    let key = key(KEY);
    let mut random = Random(7);
    let (mut right, mut waiting, mut wrong) = (0, 0, vec![]);
    for _ in 0..STUDENTS {
        let own = Beliefs {
            turn: random.belief(),
            momentum: [(); 5].map(|()| random.belief()),
            answer: random.belief(),
        };
        let text = submission(&mut random, &own);
        let graded = mark(&key, &Work::of_text("s", "s.md", Format::Markdown, &text));
        for (milestone, expected) in graded.milestones.iter().zip(truth(&own)) {
            match milestone.outcome.name() {
                found if found == expected => right += 1,
                "human" => waiting += 1,
                found => wrong.push(format!(
                    "{} is {found} and not {expected}: {}\n{text}",
                    milestone.label, milestone.reason
                )),
            }
        }
    }
    println!(
        "{right} milestones marked right, {waiting} wait for a person, {} wrong",
        wrong.len()
    );
    assert!(
        wrong.is_empty(),
        "{} wrong, {right} right, {waiting} waiting; {}",
        wrong.len(),
        wrong[0]
    );
    assert!(
        right * 100 >= (right + waiting) * 99,
        "{right} right, {waiting} wait"
    );
}
