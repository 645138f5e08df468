package org.u2sa.spark;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.apache.spark.SparkFiles;
import org.apache.spark.api.java.function.Function;
import org.u2sa.trials.campaign.WorkerProcess;

/**
 * The worker processes of one Spark executor: one per core, each executing runs sequentially.
 * Distributed as a broadcast value, so all tasks of an executor share it. The processes end with
 * the executor.
 */
final class ExecutorWorkers implements Function<String, String> {
  /** Answer for a run whose processes died; real answers are never empty. */
  static final String LOST = "";

  /** Folder into which Spark unpacks the program's archive. */
  static final String PROGRAM = "u2sa";

  private static final long serialVersionUID = 1L;
  private static final int ATTEMPTS = 2;

  private final String[] javaOptions;
  private transient Deque<WorkerProcess> idle; // created lazily on the executor

  ExecutorWorkers(List<String> javaOptions) {
    this.javaOptions = javaOptions.toArray(String[]::new);
  }

  /**
   * Executes a run.
   *
   * @param request a request line for a worker process
   * @return its answer, or {@link #LOST}
   * @throws IOException if no process can be started
   */
  @Override
  public String call(String request) throws IOException {
    for (int attempt = 1; attempt <= ATTEMPTS; attempt++) {
      WorkerProcess worker = take();
      try {
        String answer = worker.ask(request);
        giveBack(worker);
        return answer;
      } catch (IOException e) {
        worker.close();
        System.err.println("u2sa: " + e.getMessage()); // the executor's log
      }
    }
    return LOST;
  }

  private WorkerProcess take() throws IOException {
    synchronized (this) {
      if (idle == null) {
        idle = new ArrayDeque<>();
      }
      if (!idle.isEmpty()) {
        return idle.pop();
      }
    }
    return begin(Path.of(SparkFiles.get(PROGRAM)));
  }

  private synchronized void giveBack(WorkerProcess worker) {
    idle.push(worker);
  }

  private WorkerProcess begin(Path home) throws IOException {
    String classPath;
    try (Stream<Path> libraries = Files.list(home.resolve(ProgramArchive.LIBRARIES))) {
      classPath =
          libraries.sorted().map(Path::toString).collect(Collectors.joining(File.pathSeparator));
    }
    List<String> options = new ArrayList<>(List.of(javaOptions));
    options.add("-Du2sa.home=" + home);
    return new WorkerProcess(options, classPath, home, ProcessBuilder.Redirect.INHERIT);
  }
}
