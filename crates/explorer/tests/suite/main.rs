//! Tests of the interface and of the server, in one program.

mod absent_readers;
mod answers;
mod common;
mod complaints;
mod computed_maps;
mod maps;
mod samples;
mod strips;
mod three_struts;
mod wild_clients;
