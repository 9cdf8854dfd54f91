"""What all rooms use: the program, the compiled module, arguments, files."""
