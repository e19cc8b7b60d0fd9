//! Writes the certificates of checked documents into a folder.

use crate::cli::input;
use crate::report::Checked;
use crate::report::certificate::{File, files, folder};
use std::collections::BTreeSet;
use std::fs;
use std::io::{self, BufRead, BufReader};
use std::path::{Path, PathBuf};

/// Writes each document's certificates; says what went wrong and returns the exit code for it, or 0.
pub(super) fn deliver(checked: &[Checked], into: &Path) -> u8 {
    let mut taken = vec![];
    for checked in checked {
        let name = folder(&checked.report.path, &taken);
        let at = into.join(&name);
        taken.push(name);
        if let Err((path, error)) = write(&files(checked), &at) {
            eprintln!("error: {}: {error}", input::name(&path));
            return 2;
        }
    }
    0
}

fn write(files: &[File], folder: &Path) -> Result<(), (PathBuf, io::Error)> {
    let failed = |path: &Path| {
        let path = path.to_owned();
        move |error| (path, error)
    };
    fs::create_dir_all(folder).map_err(failed(folder))?;
    let current: BTreeSet<&str> = files.iter().map(|file| file.name.as_str()).collect();
    for stale in stale(folder, &current).map_err(failed(folder))? {
        fs::remove_file(&stale).map_err(failed(&stale))?;
    }
    for file in files {
        let path = folder.join(&file.name);
        fs::write(&path, &file.text).map_err(failed(&path))?;
    }
    Ok(())
}

/// Certificates of an earlier run, of lines that are proved no longer. What is no certificate is left alone.
fn stale(folder: &Path, current: &BTreeSet<&str>) -> io::Result<Vec<PathBuf>> {
    let mut found = vec![];
    for entry in fs::read_dir(folder)? {
        let entry = entry?;
        let name = entry.file_name();
        let old = name
            .to_str()
            .is_some_and(|name| name.ends_with(".txt") && !current.contains(name));
        if old && entry.file_type()?.is_file() && is_certificate(&entry.path())? {
            found.push(entry.path());
        }
    }
    Ok(found)
}

fn is_certificate(path: &Path) -> io::Result<bool> {
    let mut first = vec![];
    let mut reader = BufReader::new(fs::File::open(path)?);
    io::Read::take(&mut reader, 64).read_until(b'\n', &mut first)?;
    Ok(first == b"polhode-certificate/1\n")
}
