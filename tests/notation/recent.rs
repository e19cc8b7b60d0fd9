//! What was worked out lately: common things stay, memory is bounded, and names of things tell them apart.

use polhode::recent::{Digest, Recent};

#[test]
fn what_is_asked_for_stays_and_the_rest_is_forgotten() {
    let mut kept = Recent::of(20);
    kept.insert(0, "common", 1);
    for key in 1..100 {
        kept.insert(key, "rare", 1);
        assert_eq!(kept.get(&0), Some("common"));
    }
    assert_eq!((kept.get(&99), kept.get(&50)), (Some("rare"), None));
    let found = (0..100).filter(|key| kept.get(key).is_some());
    assert!(found.count() <= 20);
}

#[test]
fn what_weighs_much_takes_the_place_of_many() {
    let mut kept = Recent::of(20);
    (0..10).for_each(|key| kept.insert(key, (), 1));
    kept.insert(10, (), 10);
    kept.insert(11, (), 10);
    assert_eq!((kept.get(&0), kept.get(&11)), (None, Some(())));
}

#[test]
fn equal_things_have_one_digest_and_others_have_others() {
    let of = |words: &[&str]| Digest::of(words);
    assert_eq!(of(&["a", "b"]), of(&["a", "b"]));
    assert_ne!(of(&["a", "b"]), of(&["ab", ""]));
    assert_eq!(Digest::of_bytes(b"ab"), Digest::of_bytes(b"ab"));
    assert_ne!(Digest::of_bytes(b"ab"), Digest::of_bytes(b"ba"));
    let shown = format!("{:?}", of(&["a"]));
    let halves: Vec<_> = shown.split(|c: char| !c.is_ascii_digit()).collect();
    let halves: Vec<_> = halves.into_iter().filter(|half| !half.is_empty()).collect();
    assert!(
        matches!(halves[..], [one, other] if one != other),
        "{shown}"
    );
}
