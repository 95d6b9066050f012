// OpenGL ES 3 programs from their texts.
#pragma once

#include <GLES3/gl3.h>

namespace artisketch {

inline GLuint linked(const char* vertex, const char* fragment) {
  const GLuint program = glCreateProgram();
  const auto attach = [program](GLenum kind, const char* text) {
    const GLuint shader = glCreateShader(kind);
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    glAttachShader(program, shader);
    glDeleteShader(shader);  // goes with the program
  };
  attach(GL_VERTEX_SHADER, vertex);
  attach(GL_FRAGMENT_SHADER, fragment);
  glLinkProgram(program);
  return program;
}

}  // namespace artisketch
