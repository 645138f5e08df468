package org.u2sa.interfaces.disk;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.u2sa.interfaces.time.LockstepClock;
import org.u2sa.interfaces.time.SystemClock;

@Timeout(120)
class ReplacedFileTest {
  private final CountDownLatch answers = new CountDownLatch(1);
  private final List<String> made = Collections.synchronizedList(new ArrayList<>());
  private final List<String> failures = Collections.synchronizedList(new ArrayList<>());
  private final ReplacedFile file = new ReplacedFile(new SystemClock());

  @AfterEach
  void letGo() {
    answers.countDown();
  }

  private void hang() {
    DiskThread.ofProcess()
        .execute(
            () -> {
              try {
                answers.await();
              } catch (InterruptedException e) {
                throw new IllegalStateException(e);
              }
            });
  }

  private void change(ReplacedFile changed, String content) {
    changed.change(() -> made.add(content), e -> failures.add(e.getMessage()));
  }

  @Test
  void change_diskHangs_returnsAndTheLastOneIsMadeLater() throws IOException {
    hang();
    change(file, "a");
    change(file, "b");
    change(file, "c");
    assertThat(made).isEmpty();

    answers.countDown();
    assertThat(file.<List<String>>read(() -> List.copyOf(made))).containsExactly("c");
    change(file, "d");
    assertThat(file.<List<String>>read(() -> List.copyOf(made))).containsExactly("c", "d");
  }

  @Test
  void change_thatFails_isTold() throws IOException {
    file.change(
        () -> {
          throw new IOException("full");
        },
        e -> failures.add(e.getMessage()));

    assertThat(file.<List<String>>read(() -> List.copyOf(failures))).containsExactly("full");
  }

  @Test
  void read_diskHangs_failsAfterAWhile() {
    hang();

    assertThatThrownBy(() -> file.read(() -> "never"))
        .isInstanceOf(IOException.class)
        .hasMessage("the disk did not answer within 5000 ms");
  }

  @Test
  void change_inSimulatedTime_isMadeAtOnceByTheCaller() throws IOException {
    hang();
    ReplacedFile simulated = new ReplacedFile(new LockstepClock());
    change(simulated, "a");

    assertThat(made).containsExactly("a");
    assertThat(simulated.<List<String>>read(() -> List.copyOf(made))).containsExactly("a");
  }
}
