package org.u2sa.trials.campaign;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import java.util.Queue;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.function.BiConsumer;
import org.u2sa.interfaces.RunFailedException;
import org.u2sa.trials.run.HomeFolder;

/** Executes runs on several local processes and replaces processes that die. */
final class WorkerPool implements RunBackend {
  private static final int ATTEMPTS = 2;

  private final int jobs;
  private final Path directory;
  private final Object lock = new Object(); // guards the fields below
  private final Queue<RunRequest> left = new ArrayDeque<>();
  private final List<WorkerProcess> working = new ArrayList<>();
  private boolean stopped;

  /**
   * @param jobs number of processes, at least one
   * @param directory the campaign's folder; workers.log in it receives the log of the processes
   */
  WorkerPool(int jobs, Path directory) {
    this.jobs = jobs;
    this.directory = directory;
  }

  @Override
  public String inWords() {
    return jobs == 1 ? "1 process" : jobs + " processes";
  }

  @Override
  public void run(List<RunRequest> requests, BiConsumer<RunRequest, RunAnswer> done)
      throws InterruptedException {
    synchronized (lock) {
      if (!stopped) {
        left.addAll(requests);
      }
    }
    ExecutorService threads = Executors.newFixedThreadPool(jobs);
    try {
      List<Future<Void>> ends = new ArrayList<>();
      for (int i = 0; i < Math.min(jobs, requests.size()); i++) {
        Callable<Void> work =
            () -> {
              work(done);
              return null;
            };
        ends.add(threads.submit(work));
      }
      for (Future<Void> end : ends) {
        await(end);
      }
    } finally {
      stop();
      threads.shutdown();
    }
  }

  private static void await(Future<Void> end) throws InterruptedException {
    try {
      end.get();
    } catch (ExecutionException e) {
      if (e.getCause() instanceof RuntimeException known) {
        throw known;
      }
      if (e.getCause() instanceof Error error) {
        throw error;
      }
      throw new RunFailedException(
          "a process of the campaign could not be started: " + e.getCause().getMessage(), e);
    }
  }

  @Override
  public void stop() {
    synchronized (lock) {
      stopped = true;
      left.clear();
      working.forEach(WorkerProcess::close);
    }
  }

  private void work(BiConsumer<RunRequest, RunAnswer> done) throws IOException {
    WorkerProcess worker = null;
    try {
      for (RunRequest next = next(); next != null; next = next()) {
        RunAnswer answer = null;
        for (int attempt = 1; answer == null && !isStopped(); attempt++) {
          worker = worker == null ? begin() : worker;
          try {
            String line = worker.ask(RunLine.here(next, directory));
            answer = RunLine.answer(line, directory.resolve(next.folder()));
          } catch (IOException e) {
            end(worker);
            worker = null;
            answer = attempt < ATTEMPTS ? null : RunAnswer.lost(e.getMessage());
          }
        }
        tell(next, answer, done);
      }
    } catch (RuntimeException | Error e) {
      stop(); // the other runs are no longer needed
      throw e;
    } finally {
      if (worker != null) {
        end(worker);
      }
    }
  }

  private void tell(RunRequest request, RunAnswer answer, BiConsumer<RunRequest, RunAnswer> done) {
    synchronized (lock) {
      if (answer == null || stopped) {
        return; // aborted: treat the run as not started
      }
      try {
        done.accept(request, answer);
      } catch (RuntimeException | Error e) {
        stop(); // before another thread gets the lock: a failed listener receives no further events
        throw e;
      }
    }
  }

  private RunRequest next() {
    synchronized (lock) {
      return left.poll();
    }
  }

  private boolean isStopped() {
    synchronized (lock) {
      return stopped;
    }
  }

  private WorkerProcess begin() throws IOException {
    List<String> options = new ArrayList<>(WorkerProcess.javaOptions());
    options.addAll(HomeFolder.javaOptions());
    synchronized (lock) {
      WorkerProcess worker =
          new WorkerProcess(
              options,
              System.getProperty("java.class.path"),
              Path.of("").toAbsolutePath(),
              ProcessBuilder.Redirect.appendTo(directory.resolve("workers.log").toFile()));
      working.add(worker);
      if (stopped) {
        worker.close(); // stop() came between the caller's check and this process
      }
      return worker;
    }
  }

  private void end(WorkerProcess worker) {
    worker.close();
    synchronized (lock) {
      working.remove(worker);
    }
  }
}
