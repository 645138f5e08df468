import com.sun.management.OperatingSystemMXBean;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.OutputStream;
import java.io.PrintWriter;
import java.lang.management.ManagementFactory;
import java.lang.reflect.Method;
import java.nio.charset.StandardCharsets;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Runs demos in lockstep in one virtual machine, one for each line of standard input, such as {@code
 * demo ugv --seed 1}, and answers each with one line: what the run cost. {@code benchmarks/lockstep}
 * asks several of these in turn, so that versions are compared under the same load.
 */
final class Lockstep {
  private static final Pattern SIMULATED = Pattern.compile("\"simSeconds\" : ([0-9.]+)");
  private static final Pattern WALL = Pattern.compile("\"wallSeconds\" : ([0-9.]+)");

  /** The program's class, now and in versions before u2sa-cli. */
  private static final List<String> MAINS = List.of("org.u2sa.cli.Main", "org.u2sa.gcs.Main");

  private Lockstep() {}

  public static void main(String[] args) throws Exception {
    BufferedReader asked =
        new BufferedReader(new InputStreamReader(System.in, StandardCharsets.UTF_8));
    PrintWriter nowhere = new PrintWriter(OutputStream.nullOutputStream());
    PrintWriter errors = new PrintWriter(System.err, true);
    Path out = Files.createTempDirectory("u2sa-lockstep");
    OperatingSystemMXBean system =
        (OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean();
    Method program = program();
    for (String line = asked.readLine(); line != null; line = asked.readLine()) {
      Path run = Files.createTempDirectory(out, "run"); // a used folder is refused
      String[] command = (line + " --port 0 --out " + run).split(" ");
      try (Switches switches = new Switches()) {
        long cpu = cpuNanosOfOthers(system);
        int exit = (Integer) program.invoke(null, nowhere, errors, command);
        double cpuS = (cpuNanosOfOthers(system) - cpu) / 1e9;
        String summary = Files.readString(run.resolve("summary.json"));
        System.out.printf(
            Locale.ROOT,
            "{\"exit\": %d, \"simulatedS\": %s, \"wallS\": %s, \"cpuS\": %.3f, \"switches\": %d}%n",
            exit,
            number(SIMULATED, summary),
            number(WALL, summary),
            cpuS,
            switches.count());
      }
    }
  }

  private static Method program() throws ReflectiveOperationException {
    for (String main : MAINS) {
      try {
        return Class.forName(main)
            .getMethod("run", PrintWriter.class, PrintWriter.class, String[].class);
      } catch (ClassNotFoundException e) {
        continue; // another version's name
      }
    }
    throw new ClassNotFoundException("none of " + MAINS);
  }

  /** Without this thread's, which reads files before the run and draws reports after it. */
  private static long cpuNanosOfOthers(OperatingSystemMXBean system) {
    return system.getProcessCpuTime()
        - ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime();
  }

  private static String number(Pattern pattern, String text) {
    Matcher matcher = pattern.matcher(text);
    if (!matcher.find()) {
      throw new IllegalStateException("summary.json lacks " + pattern);
    }
    return matcher.group(1);
  }

  /** Counts how often threads gave their core up, as Linux says of each while it lives. */
  private static final class Switches implements AutoCloseable {
    private static final Path TASKS = Path.of("/proc/self/task");
    private static final long EVERY_MS = 500;
    private static final String KEY = "voluntary_ctxt_switches:";

    private final Map<String, Long> before = new HashMap<>();
    private final Map<String, Long> last = new HashMap<>();
    private final Thread watch = new Thread(this::watch, "switches");

    Switches() {
      look(before);
      watch.setDaemon(true);
      watch.start();
    }

    private void watch() {
      try {
        while (true) {
          Thread.sleep(EVERY_MS);
          look(last);
        }
      } catch (InterruptedException e) {
        look(last);
      }
    }

    private static void look(Map<String, Long> counts) {
      try (DirectoryStream<Path> tasks = Files.newDirectoryStream(TASKS)) {
        for (Path task : tasks) {
          for (String line : Files.readAllLines(task.resolve("status"))) {
            if (line.startsWith(KEY)) {
              counts.put(
                  task.getFileName().toString(), Long.valueOf(line.substring(KEY.length()).trim()));
            }
          }
        }
      } catch (IOException | RuntimeException e) {
        return; // a thread ended while it was looked at: the next look has the others
      }
    }

    long count() throws InterruptedException {
      watch.interrupt();
      watch.join();
      return last.entrySet().stream()
          .mapToLong(entry -> entry.getValue() - before.getOrDefault(entry.getKey(), 0L))
          .sum();
    }

    @Override
    public void close() {
      watch.interrupt();
    }
  }
}
