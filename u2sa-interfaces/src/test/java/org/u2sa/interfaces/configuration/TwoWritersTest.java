package org.u2sa.interfaces.configuration;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** Processes and objects that write one file at the same instant: no change is lost. */
@Timeout(120)
class TwoWritersTest {
  private static final int EACH = 200;

  /** Who takes the lock again at once leaves no time for others, which look each millisecond. */
  private static final long PAUSE_NANOS = 3_000_000L;

  @TempDir Path folder;
  private Path file;

  /** What each process runs: sets its half of the variables, once the other one is there, too. */
  static final class Writer {
    private Writer() {}

    public static void main(String[] arguments) throws Exception {
      Path file = Paths.get(arguments[0]);
      int first = Integer.parseInt(arguments[1]);
      XmlConfiguration configuration = XmlConfiguration.load(file);
      System.out.println("ready");
      System.in.read();
      System.exit(setAll(configuration, first));
    }
  }

  private static int setAll(XmlConfiguration configuration, int first) {
    int refused = 0;
    for (int i = first; i < first + EACH; i++) {
      refused += configuration.setVariable("V" + i, i) ? 0 : 1;
      LockSupport.parkNanos(PAUSE_NANOS);
    }
    return refused;
  }

  @BeforeEach
  void write() throws Exception {
    StringBuilder text = new StringBuilder("<configuration>\n");
    for (int i = 0; i < 2 * EACH; i++) {
      text.append("<variable name=\"V").append(i).append("\" type=\"int\" value=\"-1\"/>\n");
    }
    file = folder.resolve("X.xml");
    Files.write(
        file, text.append("</configuration>\n").toString().getBytes(StandardCharsets.UTF_8));
  }

  private void assertAllThere() throws Exception {
    XmlConfiguration configuration = XmlConfiguration.load(file);
    for (int i = 0; i < 2 * EACH; i++) {
      assertThat(configuration.getVariable("V" + i)).isEqualTo(i);
    }
    assertThat(configuration.revision()).isEqualTo(2 * EACH);
    assertThat(Files.readAllLines(folder.resolve("X.xml.audit.jsonl")))
        .hasSize(2 * EACH)
        .allMatch(line -> line.contains("ACCEPTED"));
  }

  @Test
  void setVariable_twoProcesses_noChangeIsLost() throws Exception {
    List<Process> processes = new ArrayList<>();
    try {
      for (int first : new int[] {0, EACH}) {
        processes.add(start(first));
      }
      for (Process process : processes) {
        assertThat(process.getInputStream().read()).isEqualTo('r'); // of "ready"
      }
      for (Process process : processes) {
        process.getOutputStream().write('\n');
        process.getOutputStream().flush();
      }
      for (Process process : processes) {
        assertThat(process.waitFor(100, TimeUnit.SECONDS)).isTrue();
        assertThat(process.exitValue()).as("refused").isZero();
      }
    } finally {
      processes.forEach(process -> process.destroyForcibly().onExit().join());
    }
    assertAllThere();
  }

  private Process start(int first) throws Exception {
    return new ProcessBuilder(
            Paths.get(System.getProperty("java.home"), "bin", "java").toString(),
            "-XX:TieredStopAtLevel=1",
            "-Xshare:auto",
            "-cp",
            System.getProperty("java.class.path"),
            Writer.class.getName(),
            file.toString(),
            String.valueOf(first))
        .redirectError(ProcessBuilder.Redirect.INHERIT)
        .start();
  }

  @Test
  void setVariable_twoObjectsOfOneProcess_noChangeIsLost() throws Exception {
    List<Callable<Integer>> writers = new ArrayList<>();
    writers.add(() -> setAll(XmlConfiguration.load(file), 0));
    writers.add(() -> setAll(XmlConfiguration.load(file), EACH));
    ExecutorService threads = Executors.newFixedThreadPool(2);
    try {
      for (Future<Integer> refused : threads.invokeAll(writers)) {
        assertThat(refused.get()).isZero();
      }
    } finally {
      threads.shutdownNow();
    }
    assertAllThere();
  }
}
