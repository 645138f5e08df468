package org.u2sa.trials.world;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.Callable;
import java.util.stream.Collectors;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.sim.world.World;
import org.u2sa.trials.run.SimulatedWorld;
import org.u2sa.world.xml.WorldFile;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code u2sa world check}: lists what a simulation uses from a world file and what it ignores. */
@Command(
    name = "check",
    description = {
      "Read a world file as a simulation does, and list its objects, terrain, water and wind.",
      "Also reads Gazebo worlds (.sdf, .world) and lists the elements that are not objects."
    })
final class CheckCommand implements Callable<Integer> {
  @Spec private CommandSpec command;

  @Parameters(paramLabel = "FILE", description = "The world file.")
  private Path file;

  @Override
  public Integer call() {
    PrintWriter out = command.commandLine().getOut();
    WorldFile world = WorldFile.load(file);
    List<ObjectDescription> objects = world.objects();
    List<ObjectDescription> placed = new ArrayList<>(objects);
    world.movers().forEach(each -> placed.add(each.object()));
    world.zones().forEach(each -> placed.add(each.object()));
    World simulated = SimulatedWorld.read(world, file, World.at(origin(placed)), 1L);
    out.println(file + ": " + kinds(objects));
    objects.stream()
        .collect(Collectors.groupingBy(ObjectDescription::referenceFrame, Collectors.toList()))
        .forEach((frame, all) -> out.println("  " + extent(frame, all)));
    if (world.environment().isPresent()) {
      out.println("  " + environment(simulated));
    }
    simulated.movers().forEach(mover -> out.println("  mover " + mover));
    simulated.zones().forEach(zone -> out.println("  " + zone));
    for (String words : world.ignored()) {
      boolean isMissing = world.missing().contains(words);
      out.println((isMissing ? "  not read, but possibly in the way: " : "  not read: ") + words);
    }
    return ExitCode.DONE;
  }

  /** Reference position close to the objects in GLOBAL. */
  private static Geodetic origin(List<ObjectDescription> objects) {
    return objects.stream()
        .filter(each -> each.referenceFrame().isEarth())
        .findFirst()
        .map(each -> Geodetic.of(each.in(ReferenceFrame.GLOBAL, null).center()))
        .orElse(new Geodetic(0.0, 0.0, 0.0));
  }

  private static String kinds(List<ObjectDescription> objects) {
    Map<String, Integer> kinds = new TreeMap<>();
    objects.forEach(each -> kinds.merge(each.type().name(), 1, Integer::sum));
    String each =
        kinds.entrySet().stream()
            .map(kind -> kind.getValue() + " " + kind.getKey())
            .collect(Collectors.joining(", "));
    return objects.size()
        + (objects.size() == 1 ? " object" : " objects")
        + (each.isEmpty() ? "" : ": " + each);
  }

  private static String extent(ReferenceFrame frame, List<ObjectDescription> objects) {
    DoubleSummaryStatistics x =
        objects.stream().mapToDouble(each -> each.center().x()).summaryStatistics();
    DoubleSummaryStatistics y =
        objects.stream().mapToDouble(each -> each.center().y()).summaryStatistics();
    String format =
        frame.isEarth()
            ? "%s: x %.6f…%.6f, y %.6f…%.6f (centres)"
            : "%s: x %.1f…%.1f m, y %.1f…%.1f m (centres)";
    return String.format(
        Locale.ROOT, format, frame, x.getMin(), x.getMax(), y.getMin(), y.getMax());
  }

  private static String environment(World world) {
    String water =
        world
            .water()
            .map(
                each ->
                    String.format(
                        Locale.ROOT,
                        "water at %.1f m, current %.2f m/s%s",
                        each.surfaceM(),
                        each.currentAt(Point.of(0.0, 0.0, each.surfaceM())).distance(),
                        each.waves().isPresent() ? ", waves" : ""))
            .orElse("no water");
    return String.format(
        Locale.ROOT,
        "ground up to %.1f m, slopes up to %.2f; %s; wind %.1f m/s from %.0f°, gusts σ %.1f m/s",
        world.terrain().highestM(),
        world.terrain().steepest(),
        water,
        world.wind().speedMps(),
        Math.toDegrees(world.wind().fromRad()),
        world.wind().gustSigmaMps());
  }
}
