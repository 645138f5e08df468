package org.u2sa.cli.template;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.u2sa.cli.command.BaseCommand;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.cli.command.ProgramVersion;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.xml.NearestNames;
import org.u2sa.messages.schema.MessageTypes;
import picocli.CommandLine.ArgGroup;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code u2sa new}: creates a project from a template, or adds a service to one. */
@Command(
    name = "new",
    description = {
      "Create a project with a service of your own, or add a service to a project.",
      "",
      "The result compiles, has a test and a configuration, and is yours to change. In the folder of such a project, or with --into, it adds to that project. Nothing is overwritten."
    })
public final class NewCommand extends BaseCommand {
  private static final String VEHICLE = "vehicle";
  private static final String HOME = "u2sa.home";

  private final Path here;

  @Parameters(
      index = "0",
      arity = "0..1",
      paramLabel = "KIND",
      description = "What to create; --list shows the kinds.")
  private String kind;

  @Parameters(
      index = "1",
      arity = "0..1",
      paramLabel = "NAME",
      description = "Its name, such as depth-gauge: the class is DepthGauge.")
  private String name;

  @Option(
      names = "--kind",
      paramLabel = "rover|boat|submarine|plane|copter",
      description =
          "With KIND vehicle: the vehicle file from which to create the project, to "
              + "simulate it with its devices.")
  private String vehicle; // null for the simple simulation in code

  @Option(names = "--list", description = "List the kinds and the locations of their templates.")
  private boolean list;

  @ArgGroup(exclusive = true)
  private Tool tool = new Tool();

  @Option(
      names = "--into",
      paramLabel = "DIR",
      description = "Add to the project in this folder, which has a pom.xml or build.gradle.kts.")
  private Path into;

  @Option(
      names = "--package",
      paramLabel = "PACKAGE",
      description = "Java package. Default: the project's group; of a new one org.example.NAME.")
  private String packageName;

  @Option(
      names = "--templates",
      paramLabel = "DIR|JAR",
      defaultValue = "${env:U2SA_TEMPLATES}",
      description =
          "Your organisation's templates, which take precedence over U2SA's own. Default: the environment's U2SA_TEMPLATES.")
  private String templates;

  static final class Tool {
    @Option(names = "--maven", description = "Build the new project with Maven, the default.")
    private boolean maven;

    @Option(names = "--gradle", description = "Build the new project with Gradle.")
    private boolean gradle;
  }

  /**
   * @param here current folder
   */
  public NewCommand(Path here) {
    this.here = here;
  }

  @Override
  public Integer call() throws IOException {
    Optional<Path> organisation =
        Optional.ofNullable(templates).filter(path -> !path.isEmpty()).map(Path::of);
    try (Templates available = new Templates(organisation)) {
      if (list) {
        list(available);
      } else if (kind == null || name == null) {
        throw wrong("expected KIND and NAME, such as: sensor depth-gauge");
      } else {
        make(available, available.kind(chosen(available)), Naming.of(name));
      }
    }
    return ExitCode.DONE;
  }

  /** The kind of template: {@code vehicle --kind boat} is {@code vehicle-boat}. */
  private String chosen(Templates available) {
    if (vehicle == null) {
      return kind;
    }
    if (!kind.equals(VEHICLE)) {
      throw wrong("--kind " + vehicle + ": expected KIND " + VEHICLE);
    }
    String prefix = VEHICLE + "-";
    List<String> vehicles =
        available.kinds().keySet().stream()
            .filter(each -> each.startsWith(prefix))
            .map(each -> each.substring(prefix.length()))
            .toList();
    if (!vehicles.contains(vehicle)) {
      throw wrong(
          String.format(
              "--kind %s: expected one of %s%s",
              vehicle, String.join(", ", vehicles), NearestNames.didYouMean(vehicle, vehicles)));
    }
    return prefix + vehicle;
  }

  private void list(Templates available) {
    Map<String, Templates.TemplateKind> kinds = available.kinds();
    int width = kinds.keySet().stream().mapToInt(String::length).max().orElse(0);
    for (Templates.TemplateKind each : kinds.values()) {
      String padding = " ".repeat(width - each.name().length());
      print(each.name() + padding + "  " + each.description() + " (" + each.origin() + ")");
    }
  }

  private void make(Templates available, Templates.TemplateKind chosen, Naming naming) {
    if (MessageTypes.discovered().byName(naming.className()).isPresent()) {
      throw new BadInputException(
          "name \"" + name + "\": U2SA has a message " + naming.className() + "; expected another");
    }
    Optional<Path> project = project();
    BuildTool build =
        project.map(this::toolOf).orElse(tool.gradle ? BuildTool.GRADLE : BuildTool.MAVEN);
    String inPackage =
        Naming.checkedPackage(
            Optional.ofNullable(packageName)
                .or(() -> project.flatMap(build::group))
                .orElse(naming.defaultPackage()));
    Rendering.Placeholders placeholders = placeholders(naming, inPackage, build);
    List<String> layers = new ArrayList<>();
    if (project.isEmpty()) {
      layers.addAll(List.of("project", build.template()));
    }
    layers.addAll(chosen.with());
    layers.add(chosen.name());
    Rendering rendering = new Rendering(available, layers, placeholders);
    Path folder = project.orElse(here.resolve(naming.hyphenated()));
    Destination destination = new Destination(folder);
    List<String> written =
        project.isPresent()
            ? destination.add(rendering.files(), rendering.shared())
            : destination.create(rendering.files());
    tell(chosen, folder, project.isPresent(), written, build, placeholders);
  }

  /** The project to extend; empty to create a new one. */
  private Optional<Path> project() {
    if (into != null) {
      return Optional.of(here.resolve(into));
    }
    return BuildTool.in(here).filter(known -> known.usesU2sa(here)).map(known -> here);
  }

  private BuildTool toolOf(Path project) {
    BuildTool build =
        BuildTool.in(project)
            .orElseThrow(
                () ->
                    new BadInputException(
                        project + ": expected a folder with a pom.xml or build.gradle.kts"));
    if (tool.maven && build != BuildTool.MAVEN || tool.gradle && build != BuildTool.GRADLE) {
      throw new BadInputException(
          "the project is built by "
              + build.template()
              + " ; expected neither --maven nor --gradle");
    }
    return build;
  }

  private Rendering.Placeholders placeholders(Naming naming, String inPackage, BuildTool build) {
    Map<String, String> values = new TreeMap<>();
    values.put("Name", naming.className());
    values.put("name", naming.variable());
    values.put("NAME", naming.capitals());
    values.put("file", naming.hyphenated());
    values.put("words", naming.spaced());
    values.put("package", inPackage);
    values.put("version", ProgramVersion.text());
    values.put("build", build.build);
    values.put("install", build.install);
    values.put("jars", build.jars);
    values.put("dot", "."); // build tools exclude files like .gitignore from resources
    return new Rendering.Placeholders(values);
  }

  private void tell(
      Templates.TemplateKind made,
      Path folder,
      boolean added,
      List<String> files,
      BuildTool build,
      Rendering.Placeholders placeholders) {
    String where = folder.toString().isEmpty() ? "." : folder.toString();
    print((added ? "Added to " : "Made ") + where + ":");
    files.forEach(file -> print("  " + file));
    if (added && !build.usesU2sa(folder)) {
      print("Its build does not use U2SA yet: see \"Packages\" in docs/building.md.");
    }
    String home = System.getProperty(HOME, "u2sa");
    out().println();
    print("Once, so that the build finds U2SA:");
    print("  (cd " + home + " && " + build.install + ")");
    print("Build and test it:");
    print("  " + (where.equals(".") ? "" : "cd " + where + " && ") + build.build);
    String advice =
        placeholders.fill(made.advice(), made.origin() + "/" + made.name() + "/" + Templates.ABOUT);
    advice.replace("~/u2sa", home).lines().forEach(out()::println); // one println per line
  }
}
