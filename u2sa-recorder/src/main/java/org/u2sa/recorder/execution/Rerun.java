package org.u2sa.recorder.execution;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.interfaces.time.SystemClock;
import org.u2sa.messages.schema.MessageCodec;
import org.u2sa.messages.schema.MessageTypes;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.U2SAService;

/** Re-executes one service of a recording and compares its output. */
public final class Rerun {
  private static final long HANGS_AFTER_MS = 60_000;

  private final List<Path> files;
  private final String execution;
  private final ExecutionStart start;
  private final MessageTypes types = MessageTypes.discovered();

  /**
   * Result of a re-execution.
   *
   * @param execution name of the execution
   * @param channels comparison per channel
   * @param startMicros start of the recording [µs of the run's clock]
   * @param micros run time covered [µs]
   * @param remarks reasons why the execution cannot be repeated fully
   */
  public record Outcome(
      String execution,
      List<ChannelComparison> channels,
      long startMicros,
      long micros,
      List<String> remarks) {
    public Outcome {
      channels = List.copyOf(channels);
      remarks = List.copyOf(remarks);
    }

    /** Whether everything could be compared and is byte-identical. */
    public boolean isIdentical() {
      return remarks.isEmpty() && channels.stream().allMatch(ChannelComparison::isIdentical);
    }
  }

  /**
   * @param files files of the recording, oldest first
   * @param execution name of the execution in the recording
   */
  public Rerun(List<Path> files, String execution, ExecutionStart start) {
    this.files = List.copyOf(files);
    this.execution = execution;
    this.start = start;
  }

  /**
   * Executes the service in a temporary folder, which is deleted afterwards.
   *
   * @param maker creates the service, with the class and variables to try
   * @throws IOException if the recording cannot be read or a temporary file cannot be written
   * @throws RuntimeException if the service rejects its configuration
   */
  public Outcome run(Function<ServiceContext, U2SAService> maker)
      throws IOException, InterruptedException {
    Path folder = Files.createTempDirectory("u2sa-rerun");
    try (ExecutionReader recorded =
        new ExecutionReader(files, new MessageCodec(types), execution)) {
      return run(maker, folder, recorded);
    } finally {
      delete(folder);
    }
  }

  private Outcome run(
      Function<ServiceContext, U2SAService> maker, Path folder, ExecutionReader recorded)
      throws IOException, InterruptedException {
    Clock machine = new SystemClock();
    RestoredInputs made = new RestoredInputs(start, folder);
    OutputComparison outputs = new OutputComparison(made::asRecorded);
    RepeatedExecution repeated =
        new RepeatedExecution(
            recorded, outputs, machine, start.threadId(), made.inheritance(types));
    RecordedCourse course = repeated.course();
    long fromMicros = recorded.startNanos() / 1_000L;
    ServiceContext context = made.context(types).with(repeated);
    U2SAService service;
    try {
      service = maker.apply(context);
    } catch (RuntimeException | Error e) {
      context.abandon();
      throw e;
    }
    repeated.made(service);
    service.start();
    boolean hangs = !awaitEnd(service, course);
    List<String> remarks = new ArrayList<>();
    if (hangs) {
      remarks.add("hangs: no progress for " + HANGS_AFTER_MS / 1_000 + " s");
      service.abandon();
    } else {
      course.finish();
    }
    course.failure().ifPresent(e -> remarks.add("only in part: " + e.getMessage()));
    if (course.publishedElsewhere()) {
      remarks.add("publishes from its own threads, whose output cannot be re-executed");
    }
    if (course.hasStrayed()) {
      remarks.add("read the clock, waited or published in a different order than in the recording");
    }
    return new Outcome(
        execution,
        outputs.channels(),
        fromMicros,
        Math.max(0, course.micros() - fromMicros),
        remarks);
  }

  private static boolean awaitEnd(U2SAService service, RecordedCourse course)
      throws InterruptedException {
    long passed;
    do {
      passed = course.passed();
      service.join(HANGS_AFTER_MS);
    } while (service.isAlive() && course.passed() != passed);
    return !service.isAlive();
  }

  private static void delete(Path folder) throws IOException {
    List<Path> files;
    try (Stream<Path> all = Files.walk(folder)) {
      files = all.sorted(Comparator.reverseOrder()).collect(Collectors.toList());
    }
    for (Path file : files) {
      Files.deleteIfExists(file);
    }
  }
}
