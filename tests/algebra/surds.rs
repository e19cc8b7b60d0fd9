//! Numbers with a root: `a + b √c`.

use num_rational::BigRational;
use polhode::scalar::{Ring, Surd};

fn number(n: i32) -> BigRational {
    Ring::int(n)
}

fn surd(whole: i32, part: i32) -> Surd<BigRational> {
    Surd::new(number(whole), number(part), number(3))
}

#[test]
fn division_undoes_the_product() {
    let (a, b) = (surd(2, -1), surd(-5, 4));
    assert_eq!(a.clone() * b.clone() / b, a);
    assert_eq!(surd(0, 1) * surd(0, 1), surd(3, 0));
}

#[test]
fn two_roots_make_no_number_together() {
    let other = Surd::new(number(0), number(1), number(2));
    assert!(!(surd(1, 1) + other.clone()).is_number());
    assert!((surd(1, 0) * other.clone()).is_number());
    // Not even where the parts cancel.
    let gone = surd(0, 1) + other.clone() - (other.clone() + other);
    assert!(!gone.is_number());
}

#[test]
fn it_shows_its_parts() {
    assert_eq!(surd(1, -2).to_string(), "1 + -2 √3");
    assert_eq!(surd(0, 2).to_string(), "2 √3");
}
