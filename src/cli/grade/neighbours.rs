//! What stands around a run: folders that must not be one, answers for nobody, and pages of an earlier class.

use crate::cli::grade::class::failed;
use crate::cli::grade::names::file_stem;
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

/// Refuses a folder of results that is, or lies in, the folder of submissions: what is written there would be handed in.
///
/// # Errors
///
/// In words.
pub(super) fn refuse_same(submissions: &Path, out: &Path) -> Result<(), String> {
    let (Ok(work), Some(out_there)) = (fs::canonicalize(submissions), canonical(out)) else {
        return Ok(());
    };
    match out_there.starts_with(&work) {
        true => Err(failed(
            out,
            &"the results would lie among the submissions and be taken for one; give --out a folder beside them",
        )),
        false => Ok(()),
    }
}

/// A path without links and dots, though its last parts may not be there yet.
fn canonical(path: &Path) -> Option<PathBuf> {
    let whole = std::path::absolute(path).ok()?;
    let there = whole
        .ancestors()
        .find_map(|own| Some((own, fs::canonicalize(own).ok()?)));
    let (own, there) = there?;
    Some(there.join(whole.strip_prefix(own).ok()?))
}

/// Warns of answers for students who handed in nothing.
pub(super) fn warn_of_answers(folder: &Path, ids: impl Iterator<Item = String>) {
    let known: BTreeSet<String> = ids.map(|id| file_stem(&id)).collect();
    for stem in stems(folder, "txt") {
        if known.contains(&stem) {
            continue;
        }
        let near = known
            .iter()
            .map(|own| (strsim::osa_distance(own, &stem), own));
        let near = near.min().filter(|(apart, _)| *apart <= 1 + stem.len() / 4);
        let help = match near {
            Some((_, own)) => format!("did you mean {own}.txt?"),
            None => "call the file as the student's page in feedback is called".to_owned(),
        };
        let file = folder.join(format!("{stem}.txt"));
        eprintln!(
            "warning: {}: nobody of this name handed in; {help}",
            file.display()
        );
    }
}

/// Warns of pages of students who are not in the class: they tell what an earlier run told.
pub(super) fn warn_of_pages(out: &Path, ids: impl Iterator<Item = String>) {
    let folder = out.join("feedback");
    let mut pages: BTreeSet<String> = BTreeSet::new();
    for ending in ["html", "md", "json"] {
        pages.extend(stems(&folder, ending));
    }
    for id in ids {
        pages.remove(&file_stem(&id));
    }
    if let Some(first) = pages.first() {
        eprintln!(
            "warning: {}: {} of an earlier run stand there, such as those of {first}; remove them before you hand out feedback",
            folder.display(),
            match pages.len() {
                1 => "pages of one student".to_owned(),
                count => format!("pages of {count} students"),
            }
        );
    }
}

/// Warns of a worksheet that an earlier run filled in: it tells what that run told.
pub(super) fn warn_of_worksheet(out: &Path) {
    let path = out.join("worksheet.csv");
    if path.exists() {
        eprintln!(
            "warning: {}: it is of an earlier run; give --worksheet again, or remove it",
            path.display()
        );
    }
}

/// The names of the files of a folder that end so, without the ending.
fn stems(folder: &Path, ending: &str) -> BTreeSet<String> {
    let files = fs::read_dir(folder).into_iter().flatten().flatten();
    let stems = files.filter_map(|file| {
        let path = PathBuf::from(file.file_name());
        let own = path.extension()? == ending;
        let stem = path.file_stem()?.to_str()?.to_owned();
        (own && !stem.starts_with('.')).then_some(stem)
    });
    stems.collect()
}
