package org.u2sa.cli.run;

import java.io.IOException;
import java.io.InputStream;
import java.util.concurrent.TimeUnit;
import java.util.function.IntConsumer;
import org.u2sa.cli.command.ExitCode;

/**
 * Exits this process when its parent ends. The parent holds the other end of standard input and
 * writes nothing, so end of file means that the parent is gone. An orphan would block its service's
 * name in the next run.
 */
final class ParentWatch {
  private static final long ENDS_WITHIN_S = 5;

  private final InputStream parent;
  private final IntConsumer halt;
  private volatile Runnable end = () -> {};

  /** When {@code parent} ends, {@code halt} exits the process immediately with an exit code. */
  ParentWatch(InputStream parent, IntConsumer halt) {
    this.parent = parent;
    this.halt = halt;
  }

  void start() {
    daemon("u2sa-parent", this::watch).start();
  }

  /** Sets the orderly shutdown to run first when the parent has ended. */
  void endingBy(Runnable inGoodOrder) {
    end = inGoodOrder;
  }

  private void watch() {
    try {
      while (parent.read() >= 0) {
        continue; // stray input
      }
    } catch (IOException e) {
      end(); // broken pipe: the parent is gone
      return;
    }
    end();
  }

  private void end() {
    Thread ending = daemon("u2sa-end", end);
    ending.start();
    try {
      ending.join(TimeUnit.SECONDS.toMillis(ENDS_WITHIN_S));
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    halt.accept(ExitCode.FAILED);
  }

  private static Thread daemon(String name, Runnable task) {
    Thread thread = new Thread(task, name);
    thread.setDaemon(true);
    return thread;
  }
}
