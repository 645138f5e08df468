package org.u2sa.world.sdf;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.u2sa.interfaces.xml.XmlElement;

/**
 * Finds the models and meshes of a world: {@code model://name/…}, relative to the file, or by their
 * base name for models on a server, because nothing is downloaded. Files outside the folders of the
 * world and of Gazebo's variables are not read, not even through links in these folders.
 */
public final class SdfResources {
  private static final String MODEL = "model://";
  private static final List<String> VARIABLES =
      List.of("GZ_SIM_RESOURCE_PATH", "GAZEBO_MODEL_PATH", "SDF_PATH");

  private final List<Path> roots = new ArrayList<>();

  /**
   * @param world the world file
   * @param environment variables of the process
   */
  SdfResources(Path world, Map<String, String> environment) {
    Path folder = world.toAbsolutePath().normalize().getParent();
    add(folder);
    add(folder.resolve("models"));
    if (folder.getParent() != null) {
      add(folder.getParent().resolve("models"));
    }
    folders(environment).forEach(this::add);
  }

  /** The folders that Gazebo's variables name, which may be absent. */
  public static List<Path> folders(Map<String, String> environment) {
    List<Path> folders = new ArrayList<>();
    for (String variable : VARIABLES) {
      for (String each : environment.getOrDefault(variable, "").split(":")) {
        if (!each.isEmpty()) {
          folders.add(Paths.get(each).toAbsolutePath().normalize());
        }
      }
    }
    return folders;
  }

  private void add(Path folder) {
    if (Files.isDirectory(folder)) {
      roots.add(folder);
    }
  }

  /**
   * The file or folder of a URI; empty if none of the folders contains it.
   *
   * @param from element that names it, and whose file's folder comes first
   */
  Optional<Path> find(String uri, XmlElement from) {
    List<Path> candidates = new ArrayList<>();
    try {
      if (uri.startsWith(MODEL)) {
        String rest = uri.substring(MODEL.length());
        roots.forEach(root -> candidates.add(root.resolve(rest)));
      } else if (uri.contains("://")) { // on a server such as Gazebo Fuel: look for a copy by name
        String name = uri.substring(uri.lastIndexOf('/') + 1);
        roots.forEach(root -> candidates.add(root.resolve(name)));
      } else {
        candidates.add(Paths.get(from.origin()).resolveSibling(uri));
        roots.forEach(root -> candidates.add(root.resolve(uri)));
      }
    } catch (InvalidPathException e) {
      return Optional.empty(); // not a valid file name
    }
    return candidates.stream()
        .map(path -> path.toAbsolutePath().normalize())
        .filter(path -> roots.stream().anyMatch(path::startsWith))
        .filter(this::isInside)
        .findFirst();
  }

  /** Whether a file or folder exists and, with all links followed, is in one of the folders. */
  boolean isInside(Path path) {
    try {
      Path real = path.toRealPath();
      for (Path root : roots) {
        if (real.startsWith(root.toRealPath())) {
          return true;
        }
      }
      return false;
    } catch (IOException e) {
      return false; // absent
    }
  }
}
