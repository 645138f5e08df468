package org.u2sa.network;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.net.InetAddress;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.testkit.Repository;

/** The network that the flights are broken on: it must be broken and mended as it says. */
@Tag("network")
@Timeout(120)
class LanTest {
  private static final Duration SOON = Duration.ofSeconds(20);
  private static final int ANSWER_WITHIN_MS = 1_000;

  @TempDir private Path folder;

  private static boolean answers(Lan lan, String host) throws IOException {
    return InetAddress.getByName(lan.address(host)).isReachable(ANSWER_WITHIN_MS);
  }

  @Test
  void link_cutSilencedMended_answersAccordingly() throws Exception {
    try (Lan lan = new Lan(Repository.root(), folder, "one", "two")) {
      await().atMost(SOON).until(() -> answers(lan, "one") && answers(lan, "two"));

      lan.cut("one");
      assertThat(answers(lan, "one")).isFalse();
      assertThat(answers(lan, "two")).isTrue();
      lan.mend("one");
      await().atMost(SOON).until(() -> answers(lan, "one"));

      lan.silence("one");
      assertThat(answers(lan, "one")).isFalse();
      lan.mend("one");
      await().atMost(SOON).until(() -> answers(lan, "one"));
    }
  }

  @Test
  void shape_delayAndLoss_areInEffectUntilTheyEnd() throws Exception {
    try (Lan lan = new Lan(Repository.root(), folder, "one")) {
      await().atMost(SOON).until(() -> answers(lan, "one"));

      lan.shape("one", 100.0, 0.0, 0.0);
      long began = System.nanoTime();
      assertThat(answers(lan, "one")).isTrue();
      assertThat(System.nanoTime() - began).isGreaterThan(200_000_000L); // both ways

      lan.shape("one", 0.0, 0.0, 100.0);
      assertThat(answers(lan, "one")).isFalse();

      lan.shape("one", 0.0, 0.0, 0.0);
      await().atMost(SOON).until(() -> answers(lan, "one"));
    }
  }

  @Test
  void close_programsAndHostsAreGone() throws Exception {
    Process program;
    String host;
    try (Lan lan = new Lan(Repository.root(), folder, "one")) {
      host = lan.namespace("one");
      program = new ProcessBuilder(lan.on("one", List.of("sleep", "1000"))).start();
      assertThat(namespaces()).contains(host);
    }
    assertThat(program.waitFor()).isNotZero();
    assertThat(namespaces()).doesNotContain(host);
  }

  @Test
  void lan_predecessorWasKilled_takesAwayWhatItLeft() throws Exception {
    String left;
    try (Lan lan = new Lan(Repository.root(), folder, "one")) {
      left = lan.namespace("one");
      lan.kill();
      assertThat(namespaces()).contains(left);
    }

    try (Lan next = new Lan(Repository.root(), folder, "one")) {
      assertThat(namespaces()).contains(next.namespace("one")).doesNotContain(left);
    }
  }

  private static String namespaces() throws IOException {
    Process list = new ProcessBuilder("ip", "netns", "list").start();
    return new String(list.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
  }
}
