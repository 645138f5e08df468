package org.u2sa.cli;

import java.io.PrintWriter;
import java.io.StringWriter;

/** Runs command lines and keeps their output. */
public abstract class CommandFixture {
  protected final StringWriter out = new StringWriter();
  protected final StringWriter err = new StringWriter();

  /** Runs a command line, and returns its exit code. */
  protected final int u2sa(String... arguments) {
    return Main.run(new PrintWriter(out), new PrintWriter(err), arguments);
  }
}
