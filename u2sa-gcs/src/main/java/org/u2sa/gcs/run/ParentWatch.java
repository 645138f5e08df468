package org.u2sa.gcs.run;

import java.io.IOException;
import java.io.InputStream;
import java.util.concurrent.TimeUnit;
import java.util.function.IntConsumer;
import org.u2sa.gcs.command.ExitCode;

/**
 * Ends this process when its parent has ended. The parent holds the other end of standard input and
 * writes nothing, so its end of file means that the parent is gone. An orphan would keep its
 * service's name from the next run.
 */
final class ParentWatch {
  private static final long ENDS_WITHIN_S = 5;

  private final InputStream parent;
  private final IntConsumer halt;
  private volatile Runnable end = () -> {};

  /**
   * @param parent ends when the parent has
   * @param halt ends the process at once, with that exit code
   */
  ParentWatch(InputStream parent, IntConsumer halt) {
    this.parent = parent;
    this.halt = halt;
  }

  /** Begins to watch. */
  void start() {
    daemon("u2sa-parent", this::watch).start();
  }

  /** Sets what is done first when the parent has ended: to end in good order. */
  void endingBy(Runnable inGoodOrder) {
    end = inGoodOrder;
  }

  private void watch() {
    try {
      while (parent.read() >= 0) {
        continue; // what somebody typed
      }
    } catch (IOException e) {
      end(); // the pipe is broken, which says the same
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
