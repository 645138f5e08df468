package org.u2sa.world.sdf;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.u2sa.interfaces.xml.XmlElement;

/**
 * Poses of the elements of a world or model in its frame. An element's pose may be relative to a
 * link, model, frame or joint beside it ({@code relative_to}; a frame also {@code attached_to}), as
 * in SDFormat 1.7 and later.
 */
final class SdfFrames {
  private static final Set<String> NAMED = Set.of("link", "model", "include", "frame", "joint");
  private static final Set<String> SCOPE = Set.of("", "__model__", "world");

  private static final int DEEPEST = 64; // maximum depth of poses relative to each other

  private final Map<String, XmlElement> named = new HashMap<>();
  private final List<String> ignored;

  /**
   * @param ignored receives the poses whose frame is not found, which are read as relative to the
   *     scope
   */
  SdfFrames(XmlElement scope, List<String> ignored) {
    this.ignored = ignored;
    for (XmlElement each : scope.children()) {
      if (NAMED.contains(each.name())) {
        each.optionalAttribute("name")
            .or(() -> each.child("name").map(XmlElement::text))
            .ifPresent(name -> named.putIfAbsent(name, each));
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
    SdfPose own = SdfPose.of(element);
    String frame = relativeTo(element).or(() -> usual(element)).orElse("");
    if (SCOPE.contains(frame)) {
      return own;
    }
    XmlElement found = named.get(frame);
    if (found == null) {
      ignored.add(path + ": pose relative to " + frame + ", which is not found beside it");
      return own;
    }
    return of(found, path, depth + 1).then(own);
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
