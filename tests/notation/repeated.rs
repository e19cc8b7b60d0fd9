//! Formulas that are read again: what is kept of the first reading gives what a new one would.

use polhode::notation::document::Row;
use polhode::notation::{Macros, read_formula};

/// Formulas that are kept, and others that are not.
const FORMULAS: [&str; 9] = [
    r"M_x = \dot L_x + \omega_y L_z - \omega_z L_y",
    r"3\omega_z \frac{dL_x}{dt} = -\frac{1}{2}I_{xz}^2 (\omega_z + \ddot\omega_x')",
    r"\vec M = (\dot{\vec L})_{xyz} + \vec\omega\times\mathbf L \equiv a \cdot b",
    r"= \left[\frac{d L}{dt}\right]_{B} \ne 0",
    r"a = b \tag{1}",
    r"\sin a = b",
    r"a = 2.50\ ",
    "a",
    "",
];

fn read(text: &str, offset: usize) -> Vec<Row> {
    read_formula(text, offset, &Macros::default())
}

/// Each thread keeps its own readings.
fn read_anew(text: &str, offset: usize) -> Vec<Row> {
    let text = text.to_owned();
    let reader = std::thread::spawn(move || read(&text, offset));
    reader.join().expect("a reading")
}

#[test]
fn a_formula_is_read_the_same_wherever_it_stands() {
    for text in FORMULAS {
        for offset in [7, 7, 1_000] {
            assert_eq!(read(text, offset), read_anew(text, offset), "{text}");
        }
        let spaced = format!("\n {text}  ");
        assert_eq!(read(&spaced, 998), read_anew(&spaced, 998), "{text}");
        // Spaces around a formula say nothing; a space behind a backslash does.
        if !text.ends_with(' ') {
            assert_eq!(read(&spaced, 998), read(text, 1_000), "{text}");
        }
    }
}
