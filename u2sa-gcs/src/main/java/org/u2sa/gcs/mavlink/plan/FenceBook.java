package org.u2sa.gcs.mavlink.plan;

import static java.nio.charset.StandardCharsets.UTF_8;

import io.dronefleet.mavlink.common.MavMissionResult;
import java.io.ByteArrayInputStream;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import org.u2sa.gcs.mavlink.telemetry.Placement;
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
 * The fence as items, with areas and rally points separate: the uploaded items while the Safety
 * Manager keeps them, so that they read back unchanged; otherwise its own. Shared by all stations.
 */
public final class FenceBook {
  private static final int MAX_CHARACTERS = 65_536; // of FenceOrder.fence; it is ASCII

  private final VehicleStatus vehicle;
  private final Placement placement;
  private final Map<Integer, Upload> uploaded = new ConcurrentHashMap<>(); // by MAV_MISSION_TYPE
  private int uploads;

  public FenceBook(VehicleStatus vehicle, Placement placement) {
    this.vehicle = vehicle;
    this.placement = placement;
  }

  /**
   * An upload.
   *
   * @param xml the whole resulting fence, or empty if none remains
   * @param parts the uploaded areas or rally points
   */
  record Upload(int type, String name, String xml, List<?> parts, List<MissionItem> items) {}

  /** Items, and what cannot be expressed by items. */
  record Listed(List<MissionItem> items, List<String> lost) {}

  private record Content(
      List<StationPlan.Area> areas, List<StationPlan.Place> rally, List<String> lost) {}

  /**
   * Reads uploaded items of a MAV_MISSION_TYPE; the rest of the fence in force stays, including its
   * floor and ceiling, which items cannot express.
   *
   * @throws PlanRefusal if a fence cannot have one of them
   */
  Upload read(int type, List<MissionItem> items) {
    boolean isRally = type == MissionAnswers.RALLY;
    List<StationPlan.Area> areas = isRally ? content().areas() : FenceShapes.areas(items);
    List<StationPlan.Place> rally =
        isRally ? RallyShapes.places(items, vehicle.kind(), placement.home()) : presentRally();
    List<String> lost = new ArrayList<>();
    String xml =
        areas.isEmpty() && rally.isEmpty()
            ? ""
            : PlanXml.fence(areas.isEmpty() ? "" : limits(), areas, rally, lost);
    if (!lost.isEmpty()) {
      throw new PlanRefusal(MavMissionResult.MAV_MISSION_UNSUPPORTED, PlanRefusal.some(lost));
    }
    if (xml.length() > MAX_CHARACTERS) {
      throw new PlanRefusal(
          MavMissionResult.MAV_MISSION_NO_SPACE,
          "fence of " + items.size() + " items: too long for one order; expected about 1000");
    }
    String name = "uploaded by a ground station, no. " + ++uploads;
    return new Upload(type, name, xml, isRally ? rally : areas, items);
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
    uploaded.put(accepted.type(), accepted);
  }

  /**
   * The items of a MAV_MISSION_TYPE in force.
   *
   * @throws PlanRefusal if items cannot express it
   */
  Listed listed(int type) {
    Content now = content();
    boolean isRally = type == MissionAnswers.RALLY;
    Upload newest = uploaded.get(type);
    if (newest != null && newest.parts().equals(isRally ? now.rally() : now.areas())) {
      return new Listed(newest.items(), List.of());
    }
    return isRally
        ? new Listed(RallyShapes.items(now.rally()), List.of())
        : new Listed(FenceShapes.items(now.areas()), now.lost());
  }

  private Content content() {
    FenceState state = vehicle.fence().orElseThrow(() -> refusal("no Safety Manager found"));
    if (state.file().isEmpty()) {
      return new Content(List.of(), List.of(), List.of());
    }
    String xml = state.fence().orElseThrow(() -> refusal("the fence is too long to be published"));
    List<String> lost = new ArrayList<>();
    try {
      XmlElement root = root(xml);
      return new Content(FenceAreas.read(root, lost), FenceAreas.rally(root), lost);
    } catch (BadInputException e) {
      throw refusal(e.getMessage());
    }
  }

  /** Rally points that stay when the areas change; none if plans cannot express their positions. */
  private List<StationPlan.Place> presentRally() {
    try {
      return content().rally();
    } catch (PlanRefusal e) {
      return List.of();
    }
  }

  private static PlanRefusal refusal(String why) {
    return new PlanRefusal(MavMissionResult.MAV_MISSION_ERROR, why);
  }
}
