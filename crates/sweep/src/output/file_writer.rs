//! Writes files completely or not at all: beside their place first, then renamed.

use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use tempfile::{Builder, NamedTempFile};
use thiserror::Error;
use touchdown_input::documents::input_error::InputError;

/// A writable folder.
#[derive(Debug, Clone)]
pub struct Folder {
    path: PathBuf,
}

impl Folder {
    /// Creates the folder if needed and checks that files can be written in it.
    ///
    /// # Errors
    /// Names the folder and the obstacle.
    pub fn open(path: &Path) -> Result<Self, InputError> {
        let refuse = |error: io::Error| InputError::unwritable(path, error);
        fs::create_dir_all(path).map_err(refuse)?;
        let folder = Self {
            path: path.to_owned(),
        };
        // Permissions, quotas and read-only mounts show only when a file is actually created.
        folder.beside().map_err(refuse)?;
        Ok(folder)
    }

    /// The folder of a file to be written, checked as in [`Folder::open`].
    ///
    /// # Errors
    /// Also if `file` is a folder.
    pub fn of(file: &Path) -> Result<Self, InputError> {
        if file.is_dir() || file.file_name().is_none() {
            let complaint = "is a folder: expected the name of a file";
            return Err(InputError::in_file(file, complaint));
        }
        match file.parent() {
            Some(parent) if parent != Path::new("") => Self::open(parent),
            _ => Self::open(Path::new(".")),
        }
    }

    /// The folder and the name of a file to be written, checked as in [`Folder::of`].
    ///
    /// # Errors
    /// As [`Folder::of`].
    pub fn and_name(file: &Path) -> Result<(Self, String), InputError> {
        let folder = Self::of(file)?;
        let name = file.file_name().unwrap_or(file.as_os_str());
        Ok((folder, name.to_string_lossy().into_owned()))
    }

    /// Path of a file in this folder.
    pub fn path(&self, name: &str) -> PathBuf {
        self.path.join(name)
    }

    /// Writes files: first all of them beside their places, then renames them, so that a full disk leaves old files
    /// untouched and no new ones.
    ///
    /// # Errors
    /// Names the file that could not be written.
    pub fn write_files(&self, files: &[(String, Vec<u8>)]) -> Result<Vec<PathBuf>, WriteError> {
        let drafts = files.iter().map(|(name, bytes)| self.draft_of(name, bytes));
        Draft::put_in_place(drafts.collect::<Result<_, _>>()?)
    }

    /// Starts a file for this folder.
    ///
    /// # Errors
    /// Names the file that cannot be written.
    pub fn draft(&self, name: &str) -> Result<Draft, WriteError> {
        let path = self.path(name);
        match self.beside() {
            Ok(file) => Ok(Draft { path, file }),
            Err(error) => Err(WriteError { path, error }),
        }
    }

    /// Starts a file and writes its content.
    ///
    /// # Errors
    /// Names the file that cannot be written.
    pub fn draft_of(&self, name: &str, bytes: &[u8]) -> Result<Draft, WriteError> {
        let mut draft = self.draft(name)?;
        let written = draft.file.write_all(bytes);
        written.map_err(|error| draft.refuse(error))?;
        Ok(draft)
    }

    fn beside(&self) -> io::Result<NamedTempFile> {
        let mut builder = Builder::new();
        builder.prefix(".touchdown-");
        // Temporary files are private by default; results are for everyone to read.
        #[cfg(unix)]
        builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
        builder.tempfile_in(&self.path)
    }
}

/// A file written beside its place; it is deleted unless put in place.
#[derive(Debug)]
pub struct Draft {
    path: PathBuf,
    file: NamedTempFile,
}

impl Draft {
    /// Syncs all files to disk, then puts them in their places.
    ///
    /// # Errors
    /// Names the file that could not be put in its place.
    pub fn put_in_place(drafts: Vec<Self>) -> Result<Vec<PathBuf>, WriteError> {
        for draft in &drafts {
            let synced = draft.file.as_file().sync_all();
            synced.map_err(|error| draft.refuse(error))?;
        }
        let rename = |Self { path, file }| match file.persist(&path) {
            Ok(_) => Ok(path),
            Err(error) => Err(WriteError {
                path,
                error: error.error,
            }),
        };
        drafts.into_iter().map(rename).collect()
    }

    /// Final path of the file.
    pub fn place(&self) -> &Path {
        &self.path
    }

    /// The content so far, if it is text of at most `most` bytes.
    ///
    /// # Errors
    /// If the file cannot be read.
    pub fn text(&self, most: u64) -> Result<Option<String>, WriteError> {
        let read = || {
            let length = self.file.as_file().metadata()?.len();
            match length <= most {
                true => fs::read_to_string(self.file.path()).map(Some),
                false => Ok(None),
            }
        };
        read().map_err(|error| self.refuse(error))
    }

    fn refuse(&self, error: io::Error) -> WriteError {
        let path = self.path.clone();
        WriteError { path, error }
    }
}

impl Write for Draft {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.file.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.file.flush()
    }
}

/// A file that could not be written.
#[derive(Debug, Error)]
#[error("{}: cannot be written: {error}", .path.display())]
pub struct WriteError {
    /// The file.
    pub path: PathBuf,
    /// The cause.
    pub error: io::Error,
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(folder: &Path) -> Vec<String> {
        let mut names: Vec<String> = fs::read_dir(folder)
            .unwrap()
            .map(|entry| entry.unwrap().file_name().into_string().unwrap())
            .collect();
        names.sort();
        names
    }

    #[test]
    fn files_replace_older_ones_and_nothing_else_is_left() {
        let home = tempfile::tempdir().unwrap();
        let folder = Folder::open(&home.path().join("new/results")).unwrap();
        for content in ["old", "new"] {
            let files = [
                ("a.csv".to_owned(), content.into()),
                ("b.svg".to_owned(), vec![]),
            ];
            folder.write_files(&files).unwrap();
        }
        let path = home.path().join("new/results");
        assert_eq!(names(&path), ["a.csv", "b.svg"]);
        assert_eq!(fs::read_to_string(path.join("a.csv")).unwrap(), "new");
    }

    #[test]
    fn a_folder_that_cannot_be_written_is_a_fault_of_files_and_a_name_is_not() {
        let home = tempfile::tempdir().unwrap();
        let file = home.path().join("file");
        fs::write(&file, "").unwrap();
        let unwritable = Folder::open(&file.join("results")).unwrap_err();
        assert!(unwritable.is_of_files(), "{unwritable}");
        let folder = Folder::of(home.path()).unwrap_err();
        assert!(!folder.is_of_files(), "{folder}");
    }

    #[test]
    fn one_impossible_file_leaves_nothing_beside() {
        let home = tempfile::tempdir().unwrap();
        let folder = Folder::open(home.path()).unwrap();
        fs::create_dir_all(home.path().join("a.csv/in the way")).unwrap();
        let error = folder
            .write_files(&[("a.csv".to_owned(), vec![1])])
            .unwrap_err();
        assert!(error.to_string().contains("a.csv: cannot be written"));
        assert_eq!(names(home.path()), ["a.csv"]);
    }

    #[test]
    fn a_file_is_no_folder_and_a_folder_no_file() {
        let home = tempfile::tempdir().unwrap();
        let file = home.path().join("file");
        fs::write(&file, "").unwrap();
        let complaint = Folder::open(&file.join("results")).unwrap_err().to_string();
        assert!(
            complaint.contains("output folder cannot be written"),
            "{complaint}"
        );
        assert!(
            Folder::of(home.path())
                .unwrap_err()
                .to_string()
                .contains("is a folder")
        );
        assert!(Folder::of(&home.path().join("history.csv")).is_ok());
    }
}
