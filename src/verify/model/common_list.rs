//! Lists that many documents have in common.

use std::ops::{Deref, DerefMut};
use std::slice;
use std::sync::Arc;

/// A list of which clones are one until one of them is changed.
#[derive(Debug, PartialEq)]
pub(crate) struct CommonList<T>(Arc<Vec<T>>);

impl<T> Clone for CommonList<T> {
    fn clone(&self) -> Self {
        Self(self.0.clone())
    }
}

impl<T> Default for CommonList<T> {
    fn default() -> Self {
        vec![].into()
    }
}

impl<T> From<Vec<T>> for CommonList<T> {
    fn from(list: Vec<T>) -> Self {
        Self(Arc::new(list))
    }
}

impl<T> Deref for CommonList<T> {
    type Target = Vec<T>;

    fn deref(&self) -> &Vec<T> {
        &self.0
    }
}

impl<T: Clone> DerefMut for CommonList<T> {
    fn deref_mut(&mut self) -> &mut Vec<T> {
        Arc::make_mut(&mut self.0)
    }
}

impl<'a, T> IntoIterator for &'a CommonList<T> {
    type Item = &'a T;
    type IntoIter = slice::Iter<'a, T>;

    fn into_iter(self) -> Self::IntoIter {
        self.0.iter()
    }
}

impl<'a, T: Clone> IntoIterator for &'a mut CommonList<T> {
    type Item = &'a mut T;
    type IntoIter = slice::IterMut<'a, T>;

    fn into_iter(self) -> Self::IntoIter {
        self.iter_mut()
    }
}
