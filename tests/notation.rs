//! The reader: what each spelling is read as, in every kind of file, and what becomes of text that was made to hurt.
#![cfg(feature = "verify")]

mod notation {
    mod derivatives;
    mod files;
    mod habits;
    mod hostile;
    mod lines;
    #[cfg(feature = "cli")]
    mod manual;
    mod mutations;
    mod outline;
    mod plain;
    mod print;
    mod products;
    mod rarer;
    mod vectors;
}
