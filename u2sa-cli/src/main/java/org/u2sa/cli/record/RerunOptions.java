package org.u2sa.cli.record;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.interfaces.time.SystemClock;
import org.u2sa.interfaces.xml.NearestNames;
import org.u2sa.recorder.execution.ExecutionStart;
import org.u2sa.recorder.execution.Rerun;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** Options for re-executing services of a recording; used as {@code @Mixin}. */
final class RerunOptions {
  private static final String ALL = "all";

  private final Clock clock = new SystemClock();

  @Spec(Spec.Target.MIXEE)
  private CommandSpec command;

  @Option(
      names = "--rerun",
      paramLabel = "SERVICE",
      split = ",",
      description =
          "Re-execute these services with their recorded inputs and compare what they publish; all: every service that allows it.")
  private List<String> services = List.of();

  @Option(
      names = "--against",
      paramLabel = "CHANGE",
      description = {
        "With --rerun: change the service first, and report how much its messages then differ. "
            + "CHANGE is "
            + "SERVICE:VARIABLE=VALUE, SERVICE=CLASS, or a system or configuration file. May be repeated."
      })
  private List<String> changes = List.of();

  @Option(
      names = "--page",
      paramLabel = "FILE",
      description =
          "With --rerun: write an HTML page with a chart of each number that differs, recorded and now.")
  private Path page;

  @Option(names = "--json", description = "With --rerun: print the comparison as JSON.")
  private boolean json;

  boolean isWanted() {
    if (services.isEmpty() && !changes.isEmpty()) {
      throw new ParameterException(
          command.commandLine(), "--against: requires --rerun, which defines the change");
    }
    if (services.isEmpty() && (json || page != null)) {
      throw new ParameterException(
          command.commandLine(), (json ? "--json" : "--page") + ": expected --rerun as well");
    }
    return !services.isEmpty();
  }

  int run(Path file) throws IOException, InterruptedException {
    List<Path> files = RecordingParts.beginningWith(file);
    Map<String, ExecutionStart> chosen = chosen(file, ExecutionStart.all(files));
    ServiceChanges changed = ServiceChanges.parse(changes, chosen.values());
    long began = clock.micros();
    List<Rerun.Outcome> outcomes = executed(files, chosen, changed);
    double wallS = Clock.seconds(clock.micros() - began);
    PrintWriter out = command.commandLine().getOut();
    RerunReport report = new RerunReport(outcomes, wallS, !changes.isEmpty());
    (json ? report.json() : report.lines()).forEach(out::println);
    if (page != null) {
      RerunPage.write(page, file, outcomes, changes);
      if (!json) {
        out.println(page);
      }
    }
    return report.isIdentical() || !changes.isEmpty() ? ExitCode.DONE : ExitCode.FAILED;
  }

  /** Executes the services in parallel, up to the number of processors. */
  private static List<Rerun.Outcome> executed(
      List<Path> files, Map<String, ExecutionStart> chosen, ServiceChanges changed)
      throws IOException, InterruptedException {
    ExecutorService threads =
        Executors.newFixedThreadPool(Runtime.getRuntime().availableProcessors());
    try {
      List<Future<Rerun.Outcome>> begun = new ArrayList<>();
      for (Map.Entry<String, ExecutionStart> one : chosen.entrySet()) {
        ExecutionStart start = changed.configurationOf(one.getValue());
        Rerun rerun = new Rerun(files, one.getKey(), start);
        begun.add(threads.submit(() -> rerun.run(context -> changed.make(start, context))));
      }
      List<Rerun.Outcome> outcomes = new ArrayList<>();
      for (Future<Rerun.Outcome> one : begun) {
        outcomes.add(one.get());
      }
      return outcomes;
    } catch (ExecutionException e) {
      if (e.getCause() instanceof IOException cause) {
        throw cause;
      }
      if (e.getCause() instanceof RuntimeException cause) {
        throw cause; // e.g. a service that rejects its configuration
      }
      throw new IllegalStateException(e.getCause());
    } finally {
      threads.shutdownNow();
    }
  }

  private Map<String, ExecutionStart> chosen(Path file, Map<String, ExecutionStart> all) {
    if (all.isEmpty()) {
      throw new BadInputException(
          file
              + ": contains no executions of services, only their messages. Executions are recorded when the recorder runs in the services' own process (--record, or a Recorder as the first service of the system file), records messages as they are, and is not"
              + " from an earlier version");
    }
    Map<String, ExecutionStart> chosen = new LinkedHashMap<>();
    Set<String> known = new LinkedHashSet<>();
    all.forEach(
        (name, start) -> {
          known.add(name);
          known.add(start.simpleClassName());
        });
    for (String wanted : services) {
      int before = chosen.size();
      all.forEach(
          (name, start) -> {
            boolean is =
                wanted.equals(ALL)
                    || wanted.equals(name)
                    || wanted.equals(start.service())
                    || wanted.equals(start.simpleClassName());
            if (is) {
              chosen.put(name, start);
            }
          });
      boolean found =
          chosen.size() > before || chosen.values().stream().anyMatch(s -> isNamed(s, wanted));
      if (!found) {
        throw new BadInputException(
            String.format(
                "%s: contains no execution of \"%s\"; expected one of %s%s. Services with a device, and those of other processes, have none",
                file,
                wanted,
                String.join(", ", all.keySet()),
                NearestNames.didYouMean(wanted, known)));
      }
    }
    return chosen;
  }

  private static boolean isNamed(ExecutionStart start, String wanted) {
    return wanted.equals(start.service()) || wanted.equals(start.simpleClassName());
  }
}
