package org.u2sa.network;

import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Supplier;
import org.awaitility.core.ConditionTimeoutException;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.interfaces.time.SystemClock;

/** What was measured in one flight or drive, and what failed; with the clock both are timed by. */
final class Findings implements AutoCloseable {
  /** From the end of a fault; two back-offs, a look for who is there, and a busy machine. */
  static final Duration WELL_WITHIN = Duration.ofSeconds(25);

  /** Also over a slow link and on a busy machine. */
  private static final Duration ANSWERED_WITHIN = Duration.ofSeconds(3);

  /** In which a second answer of the same service would come. */
  private static final double SETTLED_S = 0.3;

  private final Path folder;
  private final Clock clock = new SystemClock();
  private final Clock.Waiter waiter = clock.newWaiter("findings");
  private final List<String> measured = new ArrayList<>();
  private final List<String> failures = new ArrayList<>();

  Findings(Path folder) {
    this.folder = folder;
  }

  Clock clock() {
    return clock;
  }

  void pause(double seconds) throws InterruptedException {
    long until = clock.micros() + Clock.micros(seconds);
    while (clock.micros() < until) {
      waiter.await(until);
    }
  }

  void say(String format, Object... arguments) {
    String line = String.format(Locale.ROOT, format, arguments);
    measured.add(line);
    System.out.println(line);
  }

  void fail(String what) {
    failures.add(what);
  }

  List<String> failures() {
    return failures;
  }

  /**
   * Waits until nothing is wrong any more; that it did not come to that is a failure.
   *
   * @param ask asks all services again
   * @param wrong what is wrong by the answers so far
   * @return how long it took since then [s]
   */
  double awaitWell(String name, long sinceMicros, Runnable ask, Supplier<Optional<String>> wrong) {
    try {
      await(name)
          .atMost(WELL_WITHIN)
          .pollDelay(Duration.ZERO)
          .pollInterval(Duration.ofMillis(500))
          .until(() -> isWell(ask, wrong));
    } catch (ConditionTimeoutException e) {
      fail(name + ": " + wrong.get().orElse("well only now"));
    }
    return Clock.seconds(clock.micros() - sinceMicros);
  }

  private boolean isWell(Runnable ask, Supplier<Optional<String>> wrong)
      throws InterruptedException {
    ask.run();
    long deadline = clock.micros() + ANSWERED_WITHIN.toNanos() / 1_000;
    while (wrong.get().isPresent() && clock.micros() < deadline) {
      pause(0.1);
    }
    pause(SETTLED_S);
    return wrong.get().isEmpty();
  }

  /** Says the failures, and leaves all that was said in the folder's {@code measured.txt}. */
  @Override
  public void close() throws IOException {
    waiter.close();
    failures.forEach(failure -> say("FAILED: %s", failure));
    Files.write(folder.resolve("measured.txt"), measured);
  }
}
