package org.u2sa.interfaces.disk;

import java.io.IOException;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Executor;
import java.util.concurrent.FutureTask;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.ThreadFactory;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;

/**
 * A thread that accesses files in real time for those who must not wait, because a failing memory
 * card or a network drive may not answer for minutes. Jobs run one at a time in order; each user
 * bounds its pending jobs. Ends with the process.
 */
public final class DiskThread implements Executor {
  private static final DiskThread OF_PROCESS = new DiskThread("u2sa-disk");

  private final BlockingQueue<Runnable> jobs = new LinkedBlockingQueue<>();
  private final ThreadFactory threads;
  private Thread thread; // null until one could be started; guarded by this

  /** Starts a thread of this name. */
  public DiskThread(String name) {
    this(job -> new Thread(job, name));
  }

  /** Starts a thread made by the factory. */
  public DiskThread(ThreadFactory threads) {
    this.threads = threads;
    start(); // early: when the system is short of threads, the log is needed most
  }

  /** The thread for log files, saved states and missions, and recordings of links. */
  public static DiskThread ofProcess() {
    return OF_PROCESS;
  }

  /** Runs a job after all earlier ones, without waiting for it. */
  @Override
  public void execute(Runnable job) {
    jobs.add(job);
    start();
  }

  private synchronized void start() {
    if (thread != null) {
      return;
    }
    Thread made = threads.newThread(this::runAll);
    made.setDaemon(true);
    try {
      made.start();
      thread = made;
    } catch (OutOfMemoryError e) {
      thread = null; // the system has no thread left: jobs wait, and the next one tries again
    }
  }

  /** Survives every failure of a job: the thread might not be replaceable. */
  private void runAll() {
    while (true) {
      try {
        jobs.take().run();
      } catch (Throwable e) {
        Thread self = Thread.currentThread();
        self.getUncaughtExceptionHandler().uncaughtException(self, e);
      }
    }
  }

  /**
   * Runs a job after all earlier ones and waits for its result; an interrupt does not end the wait.
   *
   * @param withinMs maximum wait [ms]; the job may still run later
   * @throws IOException if the job throws it, or the disk does not answer in time
   */
  public <T> T call(Callable<T> job, long withinMs) throws IOException {
    FutureTask<T> task = new FutureTask<>(job);
    execute(task);
    boolean interrupted = false;
    try {
      while (true) {
        try {
          return task.get(withinMs, TimeUnit.MILLISECONDS);
        } catch (InterruptedException e) {
          interrupted = true; // waits again
        }
      }
    } catch (TimeoutException e) {
      throw new IOException("the disk did not answer within " + withinMs + " ms", e);
    } catch (ExecutionException e) {
      if (e.getCause() instanceof RuntimeException unexpected) {
        throw unexpected;
      }
      throw e.getCause() instanceof IOException failed ? failed : new IOException(e.getCause());
    } finally {
      if (interrupted) {
        Thread.currentThread().interrupt();
      }
    }
  }
}
