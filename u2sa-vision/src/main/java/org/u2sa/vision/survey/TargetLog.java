package org.u2sa.vision.survey;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;

/**
 * Merges sightings of the same target: its position is their mean, each field their majority vote.
 */
final class TargetLog {
  private static final double SAME_M = 10.0;
  private static final int LEAST = 2; // sightings
  private static final int MAX_TARGETS = 200;
  private static final int READ = 4; // number of agreeing fields; an orientation may remain unknown
  private static final double CLEAR_SHARE = 0.6; // fraction of the votes

  private final List<Entry> entries = new ArrayList<>();
  private int reported; // number of reports since the start; a correction refers to it

  /** The sightings of one target. */
  private static final class Entry {
    private final Geodetic first;
    private final List<Map<String, Integer>> votes = new ArrayList<>();
    private double eastM; // sums relative to the first sighting
    private double northM;
    private int count;
    private String uid = ""; // set once reported
    private int reported; // number of sightings at the last report
    private boolean isLookedAt;

    Entry(Geodetic first) {
      this.first = first;
    }

    Geodetic place() {
      return first.fromEnu(Point.of(eastM / count, northM / count, 0.0));
    }

    /**
     * Whether it was seen more than once, and most sightings agree on shape, letter and colours.
     */
    boolean isClear() {
      return count >= LEAST
          && votes.subList(0, READ).stream()
              .allMatch(each -> each.getOrDefault(most(each), 0) >= CLEAR_SHARE * count);
    }
  }

  void see(Geodetic place, List<String> fields) {
    Entry entry = null;
    for (Entry each : entries) {
      if (each.place().distanceM(place) < SAME_M) {
        entry = each;
      }
    }
    if (entry == null) {
      if (entries.size() >= MAX_TARGETS) {
        entries.remove(0);
      }
      entry = new Entry(place);
      entries.add(entry);
      fields.forEach(any -> entries.get(entries.size() - 1).votes.add(new LinkedHashMap<>()));
    }
    entry.eastM += entry.first.enuOf(place).x();
    entry.northM += entry.first.enuOf(place).y();
    entry.count++;
    for (int i = 0; i < fields.size(); i++) {
      if (!fields.get(i).isEmpty()) {
        entry.votes.get(i).merge(fields.get(i), 1, Integer::sum);
      }
    }
  }

  int size() {
    return entries.size();
  }

  /**
   * Positions of targets that a closer look may clarify; each is returned once.
   *
   * @param most maximum number of targets
   */
  List<Geodetic> unclear(int most) {
    List<Entry> unclear =
        entries.stream()
            .filter(each -> !each.isLookedAt && !each.isClear())
            .limit(most)
            .collect(Collectors.toList());
    unclear.forEach(each -> each.isLookedAt = true);
    return unclear.stream().map(Entry::place).collect(Collectors.toList());
  }

  /**
   * Reports of targets seen more than once, and of reported ones seen again since; uids remain the
   * same.
   *
   * @param sigmaM standard deviation of a sighting's position, which is mostly common to all
   */
  List<SurveyTarget> reports(double sigmaM) {
    List<SurveyTarget> reports = new ArrayList<>();
    for (Entry entry : entries) {
      if (entry.count >= LEAST && entry.count > entry.reported) {
        entry.reported = entry.count;
        List<String> fields = new ArrayList<>();
        entry.votes.forEach(votes -> fields.add(most(votes)));
        SurveyTarget report = new SurveyTarget().fields(fields).sigma(sigmaM);
        if (entry.uid.isEmpty()) {
          entry.uid = "target " + ++reported;
        }
        report.uid(entry.uid);
        report.objectType("target");
        report.referenceFrame(ReferenceFrame.GLOBAL);
        report.x(entry.place().longitudeDeg());
        report.y(entry.place().latitudeDeg());
        report.z(entry.first.altitudeM());
        reports.add(report);
      }
    }
    return reports;
  }

  private static String most(Map<String, Integer> votes) {
    String best = "";
    for (Map.Entry<String, Integer> each : votes.entrySet()) {
      if (best.isEmpty() || each.getValue() > votes.get(best)) {
        best = each.getKey();
      }
    }
    return best;
  }
}
