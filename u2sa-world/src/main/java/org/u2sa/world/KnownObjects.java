package org.u2sa.world;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import org.u2sa.interfaces.configuration.Settings;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.shape.MovingSphere;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.handover.HandOver;
import org.u2sa.world.modeller.Sighting;
import org.u2sa.world.xml.WorldFile;

/**
 * A priori objects of the world file. Objects defined relative to the vehicle's start pose are
 * omitted until a state gives that pose. Confined to the modeler's thread.
 */
final class KnownObjects {
  private final ServiceContext context;
  private final Settings<WorldVariables> settings;
  private List<ObjectDescription> all;
  private Optional<String> gap = Optional.empty();
  private long sinceMicros; // start time of the motion of the file's moving objects

  /** Loads the configured file. */
  KnownObjects(ServiceContext context, Settings<WorldVariables> settings) {
    this.context = context;
    this.settings = settings;
    load();
  }

  /** Loads the configured file; motion starts now. */
  void load() {
    all = read();
    sinceMicros = context.clock().micros();
  }

  /** Reloads the file; objects defined relative to the vehicle keep their positions. */
  void reload() {
    reload(all);
  }

  private void reload(List<ObjectDescription> before) {
    Map<String, ObjectDescription> placed =
        before.stream()
            .collect(Collectors.toMap(ObjectDescription::uid, each -> each, (a, b) -> a));
    all =
        read().stream()
            .map(each -> isAround(each) ? placed.getOrDefault(each.uid(), each) : each)
            .collect(Collectors.toList());
  }

  private List<ObjectDescription> read() {
    List<ObjectDescription> file = List.of();
    gap = Optional.empty();
    if (!settings.get().world().isEmpty()) {
      WorldFile world = world(context.configuration().namedFile(WorldVariables.WORLD));
      file = world.objects();
      gap = gap(world.missing());
    }
    return settings.get().worldMovers()
        ? file
        : file.stream().filter(object -> !moves(object)).collect(Collectors.toList());
  }

  private Optional<String> gap(List<String> missing) {
    String more = missing.size() > 1 ? ", and " + (missing.size() - 1) + " more" : "";
    return missing.stream()
        .findFirst()
        .map(
            words ->
                "not in the map, but possibly in the way: "
                    + words
                    + more
                    + " (WORLD "
                    + settings.get().world()
                    + ")");
  }

  /** What the file has that may stand in the way, but could not be read; empty if nothing. */
  Optional<String> gap() {
    return gap;
  }

  /**
   * Checks a file; nothing if the path is empty.
   *
   * @throws org.u2sa.interfaces.BadInputException naming file, line and element
   */
  void check(String path) {
    if (!path.isEmpty()) {
      world(context.configuration().resolve(path));
    }
  }

  private WorldFile world(Path file) {
    return WorldFile.load(file, context.messageTypes());
  }

  private static boolean isAround(ObjectDescription object) {
    return object.referenceFrame().isBody();
  }

  private static boolean moves(ObjectDescription object) {
    boolean turns = object instanceof MovingSphere sphere && !sphere.trajectory().isEmpty();
    return turns || object.motion().velocity().filter(v -> !v.equals(Point.ORIGIN)).isPresent();
  }

  /** Objects with a known position, as of when the file was loaded. */
  List<ObjectDescription> placed() {
    return all.stream().filter(each -> !isAround(each)).collect(Collectors.toList());
  }

  /** {@link #placed()}, moved to a time of the run's clock [µs]. */
  List<ObjectDescription> placedAt(long micros) {
    double sinceS = Clock.seconds(micros - sinceMicros);
    return placed().stream().map(object -> object.after(sinceS)).collect(Collectors.toList());
  }

  /** Motion starts when the file was loaded, no matter when a modeller asks. */
  Sighting since(Sighting now) {
    return new Sighting(sinceMicros, now.frame(), now.vehicle());
  }

  /** Fixes vehicle-relative objects, unless the map itself is still relative to the vehicle. */
  void place(Sighting now) {
    if (!now.frame().frame().isBody()) {
      all =
          all.stream()
              .map(
                  each ->
                      isAround(each) ? now.frame().placed(each, now.vehicle()).orElse(each) : each)
              .collect(Collectors.toList());
    }
  }

  void handOver(HandOver state) {
    state.text("WORLD", settings.get().world());
    state.number("WORLD SINCE", Clock.seconds(sinceMicros));
    state.messages("KNOWN", all);
  }

  /** Resumes the predecessor's objects if they come from the same file. */
  void takeOver(HandOver state) {
    if (state.text("WORLD").filter(settings.get().world()::equals).isPresent()) {
      sinceMicros = Clock.micros(state.number("WORLD SINCE").orElse(Clock.seconds(sinceMicros)));
      reload(state.messages("KNOWN", ObjectDescription.class));
    }
  }
}
