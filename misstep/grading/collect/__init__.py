"""What was handed in: files, their students, and the answers that notebooks store; read without trust."""
