//! What was worked out lately, kept in bounded memory.

use foldhash::HashMap;
use std::borrow::Borrow;
use std::hash::Hash;
use std::mem;

mod digest;

pub(crate) use digest::Digest;

/// A map that forgets what was not asked for lately.
///
/// It has two halves. When the new one is full it becomes the old one, and what was left in the old one is forgotten; what
/// is found in the old one moves into the new. So what is common stays, whatever comes between.
#[derive(Debug)]
pub(crate) struct Recent<K, V> {
    /// What the values of one half may weigh together.
    most: usize,
    weight: usize,
    new: HashMap<K, (V, usize)>,
    old: HashMap<K, (V, usize)>,
}

impl<K: Eq + Hash, V: Clone> Recent<K, V> {
    /// An empty one whose values weigh so much at most.
    pub(crate) fn of(most: usize) -> Self {
        Self {
            most: most / 2,
            weight: 0,
            new: HashMap::default(),
            old: HashMap::default(),
        }
    }

    /// The value of a key.
    pub(crate) fn get<Q: Eq + Hash + ?Sized>(&mut self, key: &Q) -> Option<V>
    where
        K: Borrow<Q>,
    {
        if let Some((value, _)) = self.new.get(key) {
            return Some(value.clone());
        }
        let (key, (value, weight)) = self.old.remove_entry(key)?;
        self.insert(key, value.clone(), weight);
        Some(value)
    }

    /// Keeps a value of this weight.
    pub(crate) fn insert(&mut self, key: K, value: V, weight: usize) {
        if self.weight + weight > self.most {
            self.old = mem::take(&mut self.new);
            self.weight = 0;
        }
        self.weight += weight;
        self.new.insert(key, (value, weight));
    }
}

#[cfg(test)]
mod tests {
    use super::Recent;

    #[test]
    fn what_is_asked_for_stays_and_the_rest_is_forgotten() {
        let mut kept = Recent::of(20);
        kept.insert(0, "common", 1);
        for key in 1..100 {
            kept.insert(key, "rare", 1);
            assert_eq!(kept.get(&0), Some("common"));
        }
        assert_eq!((kept.get(&99), kept.get(&50)), (Some("rare"), None));
        assert!(kept.new.len() + kept.old.len() <= 20);
    }

    #[test]
    fn what_weighs_much_takes_the_place_of_many() {
        let mut kept = Recent::of(20);
        (0..10).for_each(|key| kept.insert(key, (), 1));
        kept.insert(10, (), 10);
        kept.insert(11, (), 10);
        assert_eq!((kept.get(&0), kept.get(&11)), (None, Some(())));
    }
}
