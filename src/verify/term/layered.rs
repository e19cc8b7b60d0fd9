//! Maps that many documents have in common, each with what it adds.

use foldhash::HashMap;
use std::hash::Hash;
use std::sync::Arc;

/// A map of which clones have in common what was there when it was shared.
#[derive(Clone, Debug)]
pub(super) struct Layered<K, V> {
    common: Arc<HashMap<K, V>>,
    own: HashMap<K, V>,
}

impl<K, V> Default for Layered<K, V> {
    fn default() -> Self {
        Self {
            common: Arc::default(),
            own: HashMap::default(),
        }
    }
}

impl<K: Clone + Eq + Hash, V: Clone> Layered<K, V> {
    pub(super) fn get(&self, key: &K) -> Option<&V> {
        self.own.get(key).or_else(|| self.common.get(key))
    }

    /// Adds what is not there.
    pub(super) fn insert(&mut self, key: K, value: V) {
        self.own.insert(key, value);
    }

    pub(super) fn clear(&mut self) {
        *self = Self::default();
    }

    /// What is there from here on is common to all clones.
    pub(super) fn share(&mut self) {
        let own = std::mem::take(&mut self.own);
        Arc::make_mut(&mut self.common).extend(own);
    }

    /// Takes out what does not stay.
    pub(super) fn retain(&mut self, stays: impl Fn(&V) -> bool) {
        self.own.retain(|_, value| stays(value));
        if !self.common.values().all(&stays) {
            Arc::make_mut(&mut self.common).retain(|_, value| stays(value));
        }
    }
}
