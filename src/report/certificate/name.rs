//! Names for folders, from names of documents that anyone may have chosen.

/// Bytes of a name that are kept.
const LONGEST: usize = 80;

/// The folder of a document's certificates: the last part of its path in letters, digits, dots and hyphens, every other
/// byte as `_` and two hexadecimal digits. A name that was taken gets a number.
///
/// ```
/// use polhode::report::certificate::folder;
/// assert_eq!(folder("notes/week 5.md", &[]), "week_205.md");
/// assert_eq!(folder("other/week 5.md", &["week_205.md".into()]), "week_205.md-2");
/// ```
pub fn folder(path: &str, taken: &[String]) -> String {
    let last = path.rsplit(['/', '\\']).next().unwrap_or(path);
    let mut name = String::new();
    for (index, byte) in last.bytes().enumerate() {
        let dot = byte == b'.' && index > 0;
        let plain = byte.is_ascii_alphanumeric() || (byte == b'-' && index > 0) || dot;
        if plain {
            name.push(char::from(byte));
        } else {
            name.push_str(&format!("_{byte:02x}"));
        }
        if name.len() >= LONGEST {
            break;
        }
    }
    if name.is_empty() {
        name.push_str("document");
    }
    let is_taken = |name: &String| taken.iter().any(|t| t.eq_ignore_ascii_case(name));
    if !is_taken(&name) {
        return name;
    }
    let numbered = (2..).map(|n| format!("{name}-{n}"));
    numbered.into_iter().find(|n| !is_taken(n)).unwrap_or(name)
}
