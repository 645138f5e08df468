package org.u2sa.interfaces.time;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** The time of real processes that others started. */
@Timeout(120)
class SystemClockProcessTest {
  private static final long HOUR_MICROS = 3_600_000_000L;

  /** Prints which time it was when the monotonic clock read 0. */
  static final class Child {
    private Child() {}

    public static void main(String[] arguments) {
      System.out.print(zeroHere());
    }
  }

  private static long zeroOfChild(String option) throws IOException, InterruptedException {
    Process child =
        new ProcessBuilder(
                List.of(
                    Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                    option,
                    "-cp",
                    System.getProperty("java.class.path"),
                    Child.class.getName()))
            .redirectErrorStream(true)
            .start();
    String said = new String(child.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertThat(child.waitFor()).as(said).isZero();
    return Long.parseLong(said);
  }

  /** Reads both clocks at one time: again if this thread was not running in between. */
  private static long zeroHere() {
    SystemClock clock = new SystemClock();
    while (true) {
      long beforeNanos = System.nanoTime();
      long micros = clock.micros();
      if (System.nanoTime() - beforeNanos < 10_000_000L) {
        return micros - beforeNanos / 1_000L;
      }
    }
  }

  @Test
  void option_childIsStarted_itsTimeIsOurs() throws IOException, InterruptedException {
    assertThat(zeroOfChild(SystemClock.option()) - zeroHere()).isBetween(-100_000L, 100_000L);
  }

  @Test
  void option_timeOfDayIsAnHourFromOurs_childGoesByOurs() throws IOException, InterruptedException {
    // As if the machine's time of day had been set ahead since this process began.
    String[] handed = SystemClock.option().split("=|,");
    long ours = Long.parseLong(handed[1]) - HOUR_MICROS;

    long zero = zeroOfChild(handed[0] + "=" + ours + "," + handed[2]);

    assertThat(zero - (zeroHere() - HOUR_MICROS)).isBetween(-100_000L, 100_000L);
  }
}
