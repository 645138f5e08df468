package org.u2sa.scenarios.campaign;

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
import java.util.function.Consumer;
import java.util.function.Function;
import org.u2sa.gcs.command.ExitCode;
import org.u2sa.gcs.command.RunFailedException;
import org.u2sa.interfaces.BadInputException;

/**
 * Makes runs on several processes. One that dies is replaced, and its run made again; a run that
 * kills two is given up. Which process makes a run does not change what comes of it.
 */
final class WorkerPool {
  private static final int ATTEMPTS = 2;

  private final int jobs;
  private final Path log;
  private final Function<Experiment, List<String>> command;
  private final Object lock = new Object(); // guards what follows
  private final Queue<Experiment> left = new ArrayDeque<>();
  private final List<Worker> working = new ArrayList<>();
  private boolean stopped;

  /**
   * @param jobs how many processes, at least one
   * @param log takes what they say of themselves
   * @param command what makes a run and prints its {@code summary.json}
   */
  WorkerPool(int jobs, Path log, Function<Experiment, List<String>> command) {
    this.jobs = jobs;
    this.log = log;
    this.command = command;
  }

  /**
   * Makes all runs, and returns when they are done or it was stopped.
   *
   * @param done is told of each run as it ends, by one thread at a time
   * @throws BadInputException if a demo refuses its options: no more runs are begun
   */
  void run(List<Experiment> experiments, Consumer<Outcome> done) throws InterruptedException {
    synchronized (lock) {
      left.addAll(experiments);
    }
    ExecutorService threads = Executors.newFixedThreadPool(jobs);
    try {
      List<Future<Void>> ends = new ArrayList<>();
      for (int i = 0; i < Math.min(jobs, experiments.size()); i++) {
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
      throw new RunFailedException(
          "a process of the campaign could not be started: " + e.getCause().getMessage(), e);
    }
  }

  /** Begins no more runs and breaks off those under way. For any thread. */
  void stop() {
    synchronized (lock) {
      stopped = true;
      left.clear();
      working.forEach(Worker::close);
    }
  }

  private void work(Consumer<Outcome> done) throws IOException {
    Worker worker = null;
    try {
      for (Experiment next = next(); next != null; next = next()) {
        Outcome outcome = null;
        for (int attempt = 1; outcome == null && !isStopped(); attempt++) {
          worker = worker == null ? begin() : worker;
          try {
            outcome = outcome(next, worker.run(command.apply(next)));
          } catch (IOException e) {
            end(worker);
            worker = null;
            outcome =
                attempt < ATTEMPTS ? null : new Outcome(next, Outcome.LOST, "", e.getMessage());
          }
        }
        tell(outcome, done);
      }
    } catch (RuntimeException e) {
      stop(); // the others shall not go on for nothing
      throw e;
    } finally {
      if (worker != null) {
        end(worker);
      }
    }
  }

  private void tell(Outcome outcome, Consumer<Outcome> done) {
    synchronized (lock) {
      if (outcome == null || stopped) {
        return; // broken off: as if it had not been begun
      }
      if (outcome.exit() == ExitCode.BAD_INPUT) {
        throw new BadInputException(outcome.trouble());
      }
      done.accept(outcome);
    }
  }

  private static Outcome outcome(Experiment experiment, Worker.Answer answer) {
    String summary = answer.output().startsWith("{") ? answer.output() : "";
    boolean isToldInSummary = !summary.isEmpty();
    String said = isToldInSummary ? answer.errors() : answer.output() + answer.errors();
    return new Outcome(
        experiment,
        answer.exit(),
        summary,
        answer.exit() == ExitCode.DONE || isToldInSummary
            ? ""
            : said.strip().replaceFirst("^u2sa: ", ""));
  }

  private Experiment next() {
    synchronized (lock) {
      return left.poll();
    }
  }

  private boolean isStopped() {
    synchronized (lock) {
      return stopped;
    }
  }

  private Worker begin() throws IOException {
    synchronized (lock) {
      Worker worker = new Worker(log);
      working.add(worker);
      return worker;
    }
  }

  private void end(Worker worker) {
    worker.close();
    synchronized (lock) {
      working.remove(worker);
    }
  }

  /** Numbers of the processes that work now. */
  List<Long> pids() {
    synchronized (lock) {
      return working.stream().map(Worker::pid).toList();
    }
  }
}
