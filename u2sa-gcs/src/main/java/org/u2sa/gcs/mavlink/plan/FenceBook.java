package org.u2sa.gcs.mavlink.plan;

import static java.nio.charset.StandardCharsets.UTF_8;

import io.dronefleet.mavlink.common.MavMissionResult;
import java.io.ByteArrayInputStream;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.u2sa.gcs.mavlink.vehicle.VehicleStatus;
import org.u2sa.gcs.plan.FenceAreas;
import org.u2sa.gcs.plan.PlanXml;
import org.u2sa.gcs.plan.StationPlan;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.units.XmlNumbers;
import org.u2sa.interfaces.xml.XmlElement;
import org.u2sa.interfaces.xml.XmlReader;
import org.u2sa.messages.safety.FenceState;

/**
 * The fence as items: those that were uploaded if the Safety Manager keeps them, so that they are
 * read back as they were, otherwise its own. Shared by all stations.
 */
public final class FenceBook {
  private static final int MAX_CHARACTERS = 65_536; // of FenceOrder.fence; it is ASCII

  private final VehicleStatus vehicle;
  private Upload uploaded = new Upload("", "", List.of());
  private int uploads;

  public FenceBook(VehicleStatus vehicle) {
    this.vehicle = vehicle;
  }

  /** An upload: its name, its fence in XML, and its items. */
  record Upload(String name, String xml, List<MissionItem> items) {}

  /** Items, and what they cannot say. */
  record Listed(List<MissionItem> items, List<String> lost) {}

  /**
   * Reads uploaded items. Items have no floor and no ceiling: those of the fence in force stay.
   *
   * @throws PlanRefusal if a fence cannot have one of them
   */
  Upload read(List<MissionItem> items) {
    List<String> lost = new ArrayList<>();
    String xml = PlanXml.fence(limits(), FenceShapes.areas(items), lost);
    if (!lost.isEmpty()) {
      throw new PlanRefusal(MavMissionResult.MAV_MISSION_UNSUPPORTED, PlanRefusal.some(lost));
    }
    if (xml.length() > MAX_CHARACTERS) {
      throw new PlanRefusal(
          MavMissionResult.MAV_MISSION_NO_SPACE,
          "fence of " + items.size() + " items: too long for one order; expected about 1000");
    }
    return new Upload("uploaded by a ground station, no. " + ++uploads, xml, items);
  }

  private String limits() {
    StringBuilder limits = new StringBuilder();
    Optional<String> text = vehicle.fence().flatMap(FenceState::fence);
    if (text.isPresent()) {
      XmlElement root = root(text.get());
      for (String limit : List.of("floor", "ceiling")) {
        root.child(limit)
            .ifPresent(
                each ->
                    limits.append(
                        String.format(
                            "  <%1$s>%2$s</%1$s>\n", limit, XmlNumbers.converted(each, "m", "m"))));
      }
    }
    return limits.toString();
  }

  private static XmlElement root(String xml) {
    return XmlReader.read(new ByteArrayInputStream(xml.getBytes(UTF_8)), "fence", "fence");
  }

  /** Remembers an upload that the Safety Manager has accepted. */
  void accepted(Upload accepted) {
    uploaded = accepted;
  }

  /**
   * The fence in force.
   *
   * @throws PlanRefusal if items cannot express it
   */
  Listed listed() {
    FenceState state = vehicle.fence().orElseThrow(() -> refusal("no Safety Manager was heard"));
    if (state.file().isEmpty()) {
      return new Listed(List.of(), List.of());
    }
    String xml = state.fence().orElseThrow(() -> refusal("it is too long to be published"));
    if (xml.equals(uploaded.xml())) {
      return new Listed(uploaded.items(), List.of());
    }
    List<String> lost = new ArrayList<>();
    try {
      List<StationPlan.Area> areas = FenceAreas.read(root(xml), lost);
      return new Listed(FenceShapes.items(areas), lost);
    } catch (BadInputException e) {
      throw refusal(e.getMessage());
    }
  }

  private static PlanRefusal refusal(String why) {
    return new PlanRefusal(MavMissionResult.MAV_MISSION_ERROR, why);
  }
}
