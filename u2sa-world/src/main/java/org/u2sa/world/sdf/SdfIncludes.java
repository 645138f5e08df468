package org.u2sa.world.sdf;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.xml.XmlElement;
import org.u2sa.interfaces.xml.XmlReader;

/**
 * Puts the models of other files in the place of {@code <include>}, with its name, pose and
 * placement frame, as SDFormat does. What is merged remains a model of its own.
 */
final class SdfIncludes {
  private static final int DEEPEST = 16; // maximum nesting of models

  private final SdfResources resources;
  private final ReadBudget budget;
  private final SdfOmissions omissions;
  private final Map<Path, XmlElement> read = new HashMap<>();

  /**
   * @param omissions receives the includes that are not found or faulty
   */
  SdfIncludes(SdfResources resources, ReadBudget budget, SdfOmissions omissions) {
    this.resources = resources;
    this.budget = budget;
    this.omissions = omissions;
  }

  /**
   * Copy of a world or model without includes.
   *
   * @throws BadInputException if models are nested too deeply, or all files together are too long
   */
  XmlElement expanded(XmlElement scope) {
    return expanded(scope, 0);
  }

  private XmlElement expanded(XmlElement scope, int depth) {
    if (depth > DEEPEST) {
      throw scope.error("models are nested deeper than " + DEEPEST);
    }
    List<XmlElement> children = new ArrayList<>();
    for (XmlElement child : scope.children()) {
      switch (child.name()) {
        case "model" -> children.add(expanded(child, depth + 1));
        case "include" -> {
          for (XmlElement model : models(child)) {
            children.add(expanded(placed(model, child), depth + 1));
          }
        }
        default -> children.add(child);
      }
    }
    return scope.with(scope.attributes(), children, scope.text());
  }

  /** The models of the file of an include. */
  private List<XmlElement> models(XmlElement include) {
    String uri = include.requiredChild("uri").text();
    String name =
        include.child("name").map(XmlElement::text).orElse(uri.substring(uri.lastIndexOf('/') + 1));
    Optional<Path> file =
        resources
            .find(uri, include)
            .map(found -> Files.isDirectory(found) ? found.resolve("model.sdf") : found)
            .filter(Files::isRegularFile)
            .filter(resources::isInside);
    if (file.isEmpty()) {
      omissions.obstacle(name + ": model " + uri + " is not found");
      return List.of();
    }
    try {
      budget.take(file.get());
    } catch (IOException e) {
      throw new BadInputException(file.get() + ": " + e.getMessage(), e);
    }
    try {
      return read.computeIfAbsent(file.get(), path -> XmlReader.read(path, "sdf"))
          .children("model");
    } catch (BadInputException e) { // a third-party model may be faulty
      omissions.obstacle(name + ": " + e.getMessage());
      return List.of();
    }
  }

  private static XmlElement placed(XmlElement model, XmlElement include) {
    Map<String, String> attributes = new LinkedHashMap<>(model.attributes());
    include.child("name").ifPresent(name -> attributes.put("name", name.text()));
    Optional<XmlElement> pose = include.child("pose");
    include
        .child("placement_frame")
        .ifPresent(
            frame -> {
              if (pose.isEmpty()) {
                throw frame.error("expected <pose> beside it, the pose of this frame");
              }
              attributes.put("placement_frame", frame.text());
            });
    List<XmlElement> children = new ArrayList<>(model.children());
    if (pose.isPresent()) {
      children.removeIf(child -> child.name().equals("pose"));
      children.add(pose.get());
    }
    return model.with(attributes, children, model.text());
  }
}
