// Nothing: CMake wants a source to precompile the headers of the tests for.
