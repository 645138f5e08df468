package org.u2sa.spark;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.ProtocolException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.function.BiConsumer;
import org.u2sa.interfaces.RunFailedException;
import org.u2sa.trials.campaign.RunAnswer;
import org.u2sa.trials.campaign.RunBackend;
import org.u2sa.trials.campaign.RunLine;
import org.u2sa.trials.campaign.RunRequest;

/** Executes runs as Spark tasks, with the driver in a separate process. */
final class SparkRuns implements RunBackend {
  private static final String LOG = "workers.log";
  private static final String SCRATCH = "runs"; // in the program's folder on each executor

  private final SparkHome home;
  private final SparkMaster master;
  private final String localAddress;
  private final Path directory;
  private final Object lock = new Object(); // guards the fields below
  private Process driver;
  private boolean stopped;

  /** Executors reach the driver at {@code localAddress}; {@code directory} is the campaign's. */
  SparkRuns(SparkHome home, SparkMaster master, String localAddress, Path directory) {
    this.home = home;
    this.master = master;
    this.localAddress = localAddress;
    this.directory = directory;
  }

  @Override
  public String inWords() {
    return "Spark " + home.version() + ", " + master.text();
  }

  @Override
  public void run(List<RunRequest> requests, BiConsumer<RunRequest, RunAnswer> done)
      throws InterruptedException {
    if (requests.isEmpty()) {
      return;
    }
    try (DriverFiles files = DriverFiles.prepare(lines(requests))) {
      Process process = begin(files);
      if (process == null) {
        return; // already stopped
      }
      try (BufferedReader answers = process.inputReader(StandardCharsets.UTF_8)) {
        take(answers, requests, done);
      } finally {
        process.destroy();
        process.waitFor();
      }
    } catch (IOException e) {
      throw new RunFailedException("Spark could not be started: " + e.getMessage(), e);
    }
  }

  private static List<String> lines(List<RunRequest> requests) {
    return requests.stream().map(request -> RunLine.elsewhere(request, SCRATCH)).toList();
  }

  private Process begin(DriverFiles files) throws IOException {
    synchronized (lock) {
      if (!stopped) {
        ProcessBuilder builder = new ProcessBuilder(files.command(home, master, localAddress));
        builder.environment().put("SPARK_LOCAL_IP", localAddress);
        builder.redirectError(ProcessBuilder.Redirect.appendTo(directory.resolve(LOG).toFile()));
        driver = builder.start();
      }
      return driver;
    }
  }

  private void take(
      BufferedReader answers, List<RunRequest> requests, BiConsumer<RunRequest, RunAnswer> done)
      throws IOException {
    String line = next(answers);
    while (line != null && !line.equals(SparkDriver.ALL_DONE)) {
      if (line.startsWith(SparkDriver.TROUBLE)) {
        throw broken(line.substring(SparkDriver.TROUBLE.length()));
      }
      int blank = line.indexOf(' ');
      RunRequest request = request(line.substring(0, Math.max(0, blank)), requests);
      RunAnswer answer = answer(request, line.substring(blank + 1));
      synchronized (lock) {
        if (stopped) {
          return; // aborted: treat the run as not started
        }
        done.accept(request, answer);
      }
      line = next(answers);
    }
    if (line == null && !isStopped()) {
      throw broken("its driver has died");
    }
  }

  private RunRequest request(String number, List<RunRequest> requests) {
    try {
      return requests.get(Integer.parseInt(number));
    } catch (NumberFormatException | IndexOutOfBoundsException e) {
      throw broken("its driver printed a line that is not an answer");
    }
  }

  /** The next line, or null when the driver has exited or was stopped. */
  private String next(BufferedReader answers) throws IOException {
    try {
      return answers.readLine();
    } catch (IOException e) {
      if (isStopped()) {
        return null;
      }
      throw e;
    }
  }

  private RunAnswer answer(RunRequest request, String line) {
    if (line.equals(ExecutorWorkers.LOST)) {
      return RunAnswer.lost("this run has killed two processes of the campaign");
    }
    try {
      return RunLine.answer(line, directory.resolve(request.folder()));
    } catch (ProtocolException e) {
      return RunAnswer.lost(e.getMessage());
    } catch (IOException e) {
      throw new UncheckedIOException(
          "run " + request.number() + ": its files cannot be written: " + e.getMessage(), e);
    }
  }

  private RunFailedException broken(String why) {
    return new RunFailedException(
        "Spark aborted the campaign: "
            + why
            + "; its output is in "
            + directory.resolve(LOG)
            + ". The same command continues with the remaining runs");
  }

  private boolean isStopped() {
    synchronized (lock) {
      return stopped;
    }
  }

  @Override
  public void stop() {
    synchronized (lock) {
      stopped = true;
      if (driver != null) {
        driver.destroy();
      }
    }
  }
}
