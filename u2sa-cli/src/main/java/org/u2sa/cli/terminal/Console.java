package org.u2sa.cli.terminal;

import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.PrintStream;
import java.nio.charset.Charset;

/**
 * Standard output and standard error of this process. A paused terminal (Ctrl-S) or an idle pager
 * blocks output, which must not block a vehicle: while a vehicle runs, output of all threads goes
 * through a bounded queue; excess output is dropped and counted. Otherwise a program waits until
 * its output is accepted, as usual.
 */
public final class Console {
  private static final long GIVES_UP_AFTER_MS = 5_000;

  private final DetachedOutput out;
  private final DetachedOutput err;

  Console(DetachedOutput out, DetachedOutput err) {
    this.out = out;
    this.err = err;
  }

  /** Takes over {@link System#out} and {@link System#err}. */
  public static Console ofProcess() {
    Console console =
        new Console(
            new DetachedOutput(new FileOutputStream(FileDescriptor.out), GIVES_UP_AFTER_MS),
            new DetachedOutput(new FileOutputStream(FileDescriptor.err), GIVES_UP_AFTER_MS));
    System.setOut(new PrintStream(console.out, true, Charset.defaultCharset()));
    System.setErr(new PrintStream(console.err, true, Charset.defaultCharset()));
    Runtime.getRuntime().addShutdownHook(new Thread(console::drain, "u2sa-output"));
    return console;
  }

  /** Prevents threads from waiting for the output. */
  public interface Detached extends AutoCloseable {
    /** Waits until all output is written, or until none has been accepted for 5 s. */
    @Override
    void close();
  }

  /** Keeps threads from waiting for the output while the result is open. May be nested. */
  Detached detach() {
    out.detach();
    err.detach();
    return () -> {
      out.attach();
      err.attach();
    };
  }

  private void drain() {
    out.drain();
    err.drain();
  }
}
