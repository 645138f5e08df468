package org.u2sa.trials.simulate;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.Zone;

/** Counts a vehicle's entries into zones and exits from them, by its reference point. */
final class ZoneWatch {
  private final List<Stay> stays = new ArrayList<>();
  private double lastS = Double.NaN;

  /** State of one zone. */
  private static final class Stay {
    private final Zone zone;
    private boolean inside;
    private int entries;
    private int exits;
    private double firstS = Double.NaN;
    private double insideS;

    Stay(Zone zone) {
      this.zone = zone;
    }

    void see(boolean isInside, double timeS, double sinceS) {
      insideS += inside ? sinceS : 0.0;
      if (isInside && !inside) {
        entries++;
        firstS = Double.isNaN(firstS) ? timeS : firstS;
      } else if (!isInside && inside) {
        exits++;
      }
      inside = isInside;
    }
  }

  ZoneWatch(List<Zone> zones) {
    zones.forEach(zone -> stays.add(new Stay(zone)));
  }

  /** Processes a state later than the previous one; a start within a zone counts as an entry. */
  void see(VehicleTruth truth) {
    double since = Double.isNaN(lastS) ? 0.0 : truth.timeS() - lastS;
    lastS = truth.timeS();
    for (Stay stay : stays) {
      boolean isInside = stay.zone.contains(truth.position().x(), truth.position().y());
      stay.see(isInside, lastS, since);
    }
  }

  /** Entries and exits of each zone. */
  Map<String, Integer> counts() {
    Map<String, Integer> counts = new LinkedHashMap<>();
    for (Stay stay : stays) {
      counts.put("zone " + stay.zone.name() + " entries", stay.entries);
      counts.put("zone " + stay.zone.name() + " exits", stay.exits);
    }
    return counts;
  }

  /** Time in each zone, and of its first entry if there was one. */
  Map<String, Double> figures() {
    Map<String, Double> figures = new LinkedHashMap<>();
    for (Stay stay : stays) {
      figures.put("zone " + stay.zone.name() + " seconds", stay.insideS);
      if (stay.entries > 0) {
        figures.put("zone " + stay.zone.name() + " firstEntryS", stay.firstS);
      }
    }
    return figures;
  }

  /** One sentence for each keep-out zone that was entered. */
  List<String> violations() {
    List<String> all = new ArrayList<>();
    for (Stay stay : stays) {
      if (stay.zone.kind() == Zone.Kind.KEEP_OUT && stay.entries > 0) {
        all.add(
            String.format(
                Locale.ROOT,
                "keep-out zone \"%s\" was entered at %.1f s",
                stay.zone.name(),
                stay.firstS));
      }
    }
    return all;
  }
}
