//! Reads a scene file, and says at its place what is wrong with it.

mod body;
mod costs;
mod inertia;
mod reader;
mod run;
mod shape;
mod torque;
mod urdf;

pub(super) use costs::costs;

use crate::diagnostic::Diagnostic;
use crate::scene::{Group, Scene};
use crate::source::{Source, Span};
use reader::{Reader, Table, span};
use std::collections::HashMap;
use std::path::{Path, PathBuf};
use toml::de::DeTable;

/// The most bodies of a scene.
const MOST_BODIES: u64 = 10_000_000;

/// Reads a scene (TOML) and checks every value in it. A robot description that it names is looked for in the folder of
/// the source.
///
/// # Errors
/// What is wrong, each with its place and where possible a remedy; at least one.
///
/// ```
/// use polhode::{scene, source::Source};
/// let source = Source::new("scene.toml", "[[body]]\nname = 'top'\ninertai = { xx = 1 }\n");
/// let errors = scene::read(&source).expect_err("a slip of the pen");
/// assert_eq!(errors[0].helps, ["write `inertia`"]);
/// ```
pub fn read(source: &Source) -> Result<Scene, Vec<Diagnostic>> {
    let folder = Path::new(&source.name).parent();
    let mut reader = Reader {
        folder: folder.map_or_else(PathBuf::new, Path::to_owned),
        ..Reader::default()
    };
    let scene = match DeTable::parse(&source.text) {
        Ok(table) => scene(&mut reader, source, table.get_ref()),
        Err(error) => {
            let place = error.span().map_or_else(Span::default, span);
            let message = error.message().trim().replace('\n', ", ");
            reader.report(Diagnostic::error("syntax", place, message));
            None
        }
    };
    match scene {
        Some(scene) if reader.diagnostics.is_empty() => Ok(scene),
        _ => Err(reader.diagnostics),
    }
}

fn scene(reader: &mut Reader, source: &Source, entries: &DeTable<'_>) -> Option<Scene> {
    let whole = Table {
        entries,
        span: Span::new(0, 0),
        what: "a scene",
    };
    reader.known(&whole, &["body", "run"]);
    let groups = groups(reader, &whole);
    let run = match whole.get("run") {
        Some(value) => reader
            .table(value, "[run]", run::KEYS)
            .map(|table| run::run(reader, &table)),
        None => {
            let end = Span::new(source.text.len(), source.text.len());
            let missing = Diagnostic::error("missing-key", end, "the scene has no [run]");
            reader.report(missing.help("add `[run]` with `duration = 10.0`"));
            None
        }
    };
    Some(Scene {
        groups: groups?,
        run: run??,
    })
}

fn groups(reader: &mut Reader, whole: &Table<'_>) -> Option<Vec<Group>> {
    let Some(value) = whole.get("body") else {
        let none = Diagnostic::error("no-body", whole.span, "the scene has no body");
        reader.report(none.help("add `[[body]]` with a name, an inertia and an angular velocity"));
        return None;
    };
    let place = span(value.span());
    let Some(list) = value.get_ref().as_array() else {
        let single = Diagnostic::error("wrong-type", place, "`body` has to be a list of bodies");
        reader.report(single.help("write `[[body]]` with two brackets on each side"));
        return None;
    };
    if list.is_empty() {
        reader.report(Diagnostic::error(
            "no-body",
            place,
            "the list of bodies is empty",
        ));
    }
    let mut names: HashMap<String, Span> = HashMap::new();
    let mut groups = Vec::new();
    let mut count = 0_u64;
    for value in list.iter() {
        let Some(table) = reader.table(value, "a [[body]]", body::KEYS) else {
            continue;
        };
        let Some((group, name_place)) = body::group(reader, &table) else {
            continue;
        };
        if let Some(first) = names.get(&group.name) {
            let message = format!("two bodies have the name {:?}", group.name);
            let twice = Diagnostic::error("duplicate-name", name_place, message);
            reader.report(twice.other(*first, "the first of them"));
        }
        names.insert(group.name.clone(), name_place);
        count = count.saturating_add(group.count);
        let fits = count.saturating_sub(group.count) <= MOST_BODIES;
        if count > MOST_BODIES && fits {
            let message = format!(
                "the scene has {count} bodies up to here, and at most {MOST_BODIES} are computed"
            );
            let place = table
                .get("count")
                .map_or(name_place, |value| span(value.span()));
            reader.report(Diagnostic::error("too-many-bodies", place, message));
        }
        groups.push(group);
    }
    Some(groups)
}
