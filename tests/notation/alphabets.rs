//! Letters of other alphabets that look like Latin ones.

use polhode::notation::lookalike;

#[test]
fn a_letter_that_only_looks_latin_is_found() {
    assert_eq!(lookalike("\u{430}da"), Some(('\u{430}', 'a')));
    assert_eq!(lookalike("\u{39c}_x = 1"), Some(('\u{39c}', 'M')));
    for plain in [
        "ada",
        "José",
        "Ω_x",
        "Анна-2",
        "王wei",
        "J_{пр}",
        "\\text{масса}",
    ] {
        assert_eq!(lookalike(plain), None, "{plain}");
    }
}
