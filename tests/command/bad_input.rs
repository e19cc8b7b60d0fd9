//! Input that is no derivation: a clear message with a place, an honest exit code, no panic.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use tempfile::TempDir;

/// A folder that holds one document.
fn document(bytes: &[u8]) -> (TempDir, PathBuf) {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let path = folder.path().join("work.md");
    fs::write(&path, bytes).expect("a file that can be written");
    (folder, path)
}

fn check(path: &Path) -> (i32, String, String) {
    let Output {
        status,
        stdout,
        stderr,
    } = Command::new(env!("CARGO_BIN_EXE_polhode"))
        .arg("check")
        .arg(path)
        .stdin(Stdio::null())
        .output()
        .expect("the command starts");
    let text = |bytes| String::from_utf8(bytes).expect("UTF-8");
    let code = status.code().expect("an exit code, not a signal");
    (code, text(stdout), text(stderr))
}

/// The code and the text for a document that can be read as a file.
fn checked(text: &str) -> (i32, String) {
    let (_folder, path) = document(text.as_bytes());
    let (code, stdout, stderr) = check(&path);
    assert_eq!(stderr, "");
    (code, stdout)
}

fn refused(path: &Path, reason: &str) {
    let (code, stdout, stderr) = check(path);
    assert_eq!((code, stdout.as_str()), (2, ""));
    assert_eq!(stderr, format!("error: {}: {reason}\n", path.display()));
}

#[test]
fn what_is_no_text_file_is_refused_with_the_reason() {
    let (folder, path) = document(b"L = \xff\xfeI");
    refused(&path, "is not UTF-8: the byte at offset 4 fits nowhere");
    refused(folder.path(), "is a directory; name the files in it");
    refused(&folder.path().join("missing.md"), "there is no such file");
    let (_folder, path) = document(b"\xff\xfeL\0");
    refused(&path, "is UTF-16; save it as UTF-8");
}

#[test]
fn a_byte_order_mark_is_no_text() {
    let text = "---\npolhode:\n- N is an inertial frame.\n- nonsense\n---\n\n$$ \\cos 0 = 1 $$\n";
    let (_folder, path) = document(text.as_bytes());
    let (_other, marked) = document(format!("\u{feff}{text}").as_bytes());
    let told = |path: &Path| {
        let (code, stdout, stderr) = check(path);
        let nameless = |text: String| text.replace(&path.display().to_string(), "");
        (code, nameless(stdout), nameless(stderr))
    };
    let plain = told(&path);
    assert!(format!("{plain:?}").contains("nonsense"), "{plain:?}");
    assert_eq!(told(&marked), plain);
}

#[cfg(unix)]
#[test]
fn a_device_that_never_ends_is_refused() {
    refused(
        Path::new("/dev/zero"),
        "is no regular file; send it through standard input, as `-`",
    );
}

#[test]
fn a_file_beyond_the_limit_is_refused_unread() {
    let (_folder, path) = document(b"");
    let file = fs::File::create(&path).expect("writable");
    file.set_len((64 << 20) + 1).expect("a sparse file");
    refused(&path, "is larger than 64 MB");
}

#[test]
fn a_formula_without_an_end_is_shown_where_it_begins() {
    let (code, text) = checked("Then\n\n$$ L_x = I_x \\omega_x\n\nand so on.\n");
    assert_eq!(code, 3);
    assert!(
        text.starts_with("unreadable: a formula that is not closed"),
        "{text}"
    );
    assert!(text.contains("work.md:3:1"), "{text}");
}

#[test]
fn an_unknown_macro_is_named_at_its_place() {
    let (code, text) = checked("Then $L_x = \\wobble{\\omega_x}$.\n");
    assert_eq!(code, 3);
    assert!(
        text.starts_with("unreadable: ") && text.contains("\\wobble"),
        "{text}"
    );
    assert!(text.contains("work.md:1:13"), "{text}");
}

#[test]
fn brackets_nested_without_end_are_a_message() {
    for (open, close) in [
        ("{", "}"),
        ("\\left(", "\\right)"),
        ("\\frac{1}{", "}"),
        ("\\dot{", "}"),
    ] {
        let formula = format!(
            "$$L_x = {}\\omega_x{}$$\n",
            open.repeat(10_000),
            close.repeat(10_000)
        );
        let (code, text) = checked(&formula);
        assert_eq!(code, 3, "{open}");
        let told = ["unreadable: ", "error[unreadable]: "];
        let told = told.iter().any(|start| text.starts_with(start));
        assert!(told, "{open}: {text}");
        assert!(text.contains("work.md:1:"), "{open}: {text}");
        // A drawing quotes a window of the line, not the line.
        assert!(text.len() < 4_000, "{open}: {} bytes", text.len());
    }
}

#[test]
fn other_characters_than_letters_are_no_panic() {
    for strange in [
        "\0",
        "\u{202e}",
        "\u{feff}",
        "\u{1b}[31m",
        "\u{10ffff}",
        "é\u{301}\u{301}",
        "\r",
    ] {
        let (code, text) = checked(&format!(
            "Let{strange} $L_x{strange} = I_x {strange}\\omega_x$.\n"
        ));
        assert!([0, 1, 3].contains(&code), "{strange:?}");
        assert!(
            !text.contains('\u{1b}') && !text.contains('\u{202e}'),
            "{text:?}"
        );
    }
}

#[test]
fn a_document_with_nothing_in_it_says_so() {
    for text in ["", "\n\n", "Words and no formula.\n"] {
        let (code, shown) = checked(text);
        assert_eq!(code, 0);
        assert!(shown.ends_with("work.md: no line to check\n"), "{shown}");
    }
}
