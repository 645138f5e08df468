package org.u2sa.world.sdf;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.u2sa.interfaces.xml.XmlElement;

/**
 * Poses of the elements of a world or model in its frame. An element's pose may be relative to a
 * link, model, frame or joint beside it ({@code relative_to}; a frame also {@code attached_to}), as
 * in SDFormat 1.7 and later, or to one inside a model beside it ({@code model::frame}). The pose of
 * a model is that of its {@code placement_frame}.
 */
final class SdfFrames {
  private static final Set<String> NAMED = Set.of("link", "model", "frame", "joint");
  private static final Set<String> SCOPE = Set.of("", "__model__", "world");

  private static final String INSIDE = "::";
  private static final int DEEPEST = 64; // maximum depth of poses relative to each other

  private final Map<String, XmlElement> named = new HashMap<>();
  private final SdfOmissions omissions;

  /**
   * @param omissions receives the poses whose frame is not found, which are read as relative to the
   *     scope
   */
  SdfFrames(XmlElement scope, SdfOmissions omissions) {
    this.omissions = omissions;
    for (XmlElement each : scope.children()) {
      if (NAMED.contains(each.name())) {
        each.optionalAttribute("name").ifPresent(name -> named.putIfAbsent(name, each));
      }
    }
  }

  /**
   * Pose of an element of the scope in the scope's frame.
   *
   * @param path its name for reports
   */
  SdfPose of(XmlElement element, String path) {
    return of(element, path, 0);
  }

  /** Pose of a part of a link in the scope's frame; by default it is relative to the link. */
  SdfPose ofPart(XmlElement part, XmlElement link, String path) {
    return relativeTo(part).isEmpty() ? of(link, path).then(SdfPose.of(part)) : of(part, path);
  }

  private SdfPose of(XmlElement element, String path, int depth) {
    if (depth > DEEPEST) {
      throw element.error(
          "poses are relative to each other more than " + DEEPEST + " deep, or in a circle");
    }
    SdfPose own = SdfPose.of(element).then(fromPlacement(element, path, depth));
    String frame = relativeTo(element).or(() -> usual(element)).orElse("");
    return named(frame, path, depth).then(own);
  }

  /** Pose of a frame of the scope by its name. */
  private SdfPose named(String frame, String path, int depth) {
    if (SCOPE.contains(frame)) {
      return SdfPose.NONE;
    }
    int inner = named.containsKey(frame) ? -1 : frame.indexOf(INSIDE);
    XmlElement found = named.get(inner < 0 ? frame : frame.substring(0, inner));
    if (found == null) {
      omissions.obstacle(path + ": pose relative to " + frame + ", which is not found");
      return SdfPose.NONE;
    }
    SdfPose pose = of(found, path, depth + 1);
    if (inner < 0) {
      return pose;
    }
    String rest = frame.substring(inner + INSIDE.length());
    return pose.then(new SdfFrames(found, omissions).named(rest, path, depth + 1));
  }

  /** Pose of a model in its placement frame. */
  private SdfPose fromPlacement(XmlElement element, String path, int depth) {
    String frame =
        element.name().equals("model")
            ? element.optionalAttribute("placement_frame").orElse("")
            : "";
    return frame.isEmpty()
        ? SdfPose.NONE
        : new SdfFrames(element, omissions).named(frame, path, depth + 1).inverse();
  }

  private static Optional<String> relativeTo(XmlElement element) {
    return element
        .child("pose")
        .flatMap(pose -> pose.optionalAttribute("relative_to"))
        .filter(frame -> !frame.isEmpty());
  }

  /** Frame of a pose that does not name one. */
  private static Optional<String> usual(XmlElement element) {
    return switch (element.name()) {
      case "frame" -> element.optionalAttribute("attached_to");
      case "joint" -> element.child("child").map(XmlElement::text);
      default -> Optional.empty();
    };
  }
}
