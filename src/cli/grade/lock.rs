//! One run at a time writes into a folder of results: two would write over each other's journal and pages.
//!
//! The system holds the lock for a run and lets it go when the run ends, however it ends: what a killed run leaves is a file
//! that nobody holds.

use crate::cli::grade::class::{Part, failed};
use std::fs::{File, OpenOptions, TryLockError};
use std::io;
use std::path::Path;

/// Held as long as it lives.
pub(super) struct Lock {
    _held: Vec<File>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Hold {
    /// No other run may be there.
    Alone,
    /// Other runs may be there that hold it so.
    Shared,
}

impl Lock {
    /// For a run that writes the results of the whole class.
    pub(super) fn of_class(out: &Path) -> Result<Self, String> {
        let held = held(out, ".lock", Hold::Alone)?;
        Ok(Self { _held: vec![held] })
    }

    /// For a run that marks one part, beside those that mark others.
    pub(super) fn of_part(out: &Path, part: Part) -> Result<Self, String> {
        let class = held(out, ".lock", Hold::Shared)?;
        let name = format!("part-{}-of-{}.lock", part.number, part.of);
        let own = held(out, &name, Hold::Alone)?;
        Ok(Self {
            _held: vec![class, own],
        })
    }
}

fn held(out: &Path, name: &str, hold: Hold) -> Result<File, String> {
    let path = out.join(name);
    let mut options = OpenOptions::new();
    let file = options
        .read(true)
        .write(true)
        .create(true)
        .truncate(false)
        .open(&path);
    let file = file.map_err(|error| failed(&path, &error))?;
    let locked = match hold {
        Hold::Alone => file.try_lock(),
        Hold::Shared => file.try_lock_shared(),
    };
    match locked {
        Ok(()) => Ok(file),
        Err(TryLockError::WouldBlock) => Err(failed(
            out,
            &"another run is writing into this folder; wait until it ends, or give another folder with --out",
        )),
        // Some network folders have no locks; the journal still tells what is whole.
        Err(TryLockError::Error(error)) if error.kind() == io::ErrorKind::Unsupported => {
            eprintln!(
                "warning: {}: this file system has no locks; let no other run write into it",
                out.display()
            );
            Ok(file)
        }
        Err(TryLockError::Error(error)) => Err(failed(&path, &error)),
    }
}
