package org.u2sa.scenarios.station;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.interfaces.mqtt.LocalToken;
import org.u2sa.scenarios.run.ForeignProgram;
import org.u2sa.testkit.FreePort;
import org.u2sa.testkit.NeedsProgram;
import org.u2sa.testkit.ProcessTree;

/** A recorded drive in the operator's page, in Chromium. */
@Tag("browser")
@NeedsProgram("chromium")
@Timeout(300)
class StationPlaybackTest {
  private static final Duration LONG = Duration.ofSeconds(90);

  @TempDir private Path folder;

  @Test
  void replay_onThePage_playsPausesSeeksAndOrdersNothing() throws Exception {
    Path drive = folder.resolve("drive");
    Process demo =
        ForeignProgram.u2sa(
            folder.resolve("demo.txt"),
            "demo",
            "ugv",
            "--loops",
            "1",
            "--seed",
            "4",
            "--record",
            "--out",
            drive.toString());
    assertThat(demo.waitFor(LONG.toSeconds(), TimeUnit.SECONDS)).isTrue();
    int port = FreePort.find();
    Path output = folder.resolve("replay.txt");
    String file = drive.resolve("recording.mcap").toString();
    Process replay =
        ForeignProgram.u2sa(output, "replay", file, "--from", "20", "--web", String.valueOf(port));
    try {
      String page = "http://127.0.0.1:" + port + "/";
      await().atMost(LONG).until(() -> Files.readString(output, UTF_8).contains(page));
      String token = new String(LocalToken.read("127.0.0.1", port + 1).orElseThrow());
      try (HeadlessBrowser browser = new HeadlessBrowser(folder.resolve("profile"), 1200, 800)) {
        browser.open(page + "#" + token);
        browser.awaitText("recording", "RECORDING");
        browser.awaitText("position-text", "0:2"); // begins at 20 s
        browser.awaitText("doing", "to "); // the retained goals were published before
        browser.awaitText("instruments", "m/s");
        assertThat(
                browser.evaluate("document.getElementById('estop').checkVisibility()").asBoolean())
            .isFalse();

        browser.press("play");
        browser.awaitText("play", "Play");
        browser.evaluate(
            "(() => { const bar = document.getElementById('position'); bar.value = 75;"
                + " bar.dispatchEvent(new Event('change')); })()");
        browser.awaitText("position-text", "1:15.0");
        browser.press("ahead");
        browser.awaitText("position-text", "1:20.0");
        browser.press("play");
        await().atMost(LONG).until(() -> !browser.text("position-text").startsWith("1:20.0"));

        browser.evaluate("document.getElementById('hold').click()"); // hidden
        browser.awaitText("outcome", "this is a recording");
        assertThat(browser.errors).isEmpty();
        assertThat(browser.requests).allMatch(url -> url.contains("//127.0.0.1:" + port + "/"));
      }
    } finally {
      ProcessTree.kill(replay);
    }
  }
}
