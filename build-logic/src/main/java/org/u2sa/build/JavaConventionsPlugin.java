package org.u2sa.build;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import org.gradle.api.Plugin;
import org.gradle.api.Project;
import org.gradle.api.artifacts.VersionCatalog;
import org.gradle.api.artifacts.VersionCatalogsExtension;
import org.gradle.api.plugins.JavaPlugin;
import org.gradle.api.plugins.JavaPluginExtension;
import org.gradle.api.provider.Provider;
import org.gradle.api.publish.PublishingExtension;
import org.gradle.api.publish.maven.MavenPom;
import org.gradle.api.publish.maven.MavenPublication;
import org.gradle.api.tasks.bundling.AbstractArchiveTask;
import org.gradle.api.tasks.bundling.Jar;
import org.gradle.api.tasks.compile.JavaCompile;
import org.gradle.api.tasks.javadoc.Javadoc;
import org.gradle.api.tasks.testing.Test;
import org.gradle.external.javadoc.StandardJavadocDocletOptions;

/**
 * The plugin {@code u2sa.java-conventions}: a published Java 17 library with JUnit tests. Written in Java on Gradle's own
 * interfaces, so that building it needs nothing from a plugin repository.
 */
public class JavaConventionsPlugin implements Plugin<Project> {
  private static final int JAVA_RELEASE = 17;
  private static final List<String> COMPILER_ARGUMENTS =
      List.of(
          "-Xlint:all,-processing,-classfile",
          "-Xdoclint:all/protected,-missing",
          "-Werror",
          "-parameters");
  private static final String EXCLUDED_TAGS = "long,flightgear,network,chaos,android,spark,browser";
  private static final List<String> TEST_CLASSES = List.of("**/*Test", "**/*Properties");
  private static final int TEST_FORKS = 2;
  private static final String TEST_JVM = "-XX:+UseSerialGC -XX:TieredStopAtLevel=1";

  @Override
  public void apply(Project project) {
    project.getPluginManager().apply("java-library");
    project.getPluginManager().apply("maven-publish");
    compile(project);
    test(project);
    publish(project);
  }

  private static void compile(Project project) {
    JavaPluginExtension java = project.getExtensions().getByType(JavaPluginExtension.class);
    java.withSourcesJar();
    java.withJavadocJar();
    project
        .getTasks()
        .withType(JavaCompile.class)
        .configureEach(
            task -> {
              task.getOptions().setEncoding("UTF-8");
              task.getOptions().getRelease().set(JAVA_RELEASE);
              task.getOptions().getCompilerArgs().addAll(COMPILER_ARGUMENTS);
            });
    project
        .getTasks()
        .withType(Javadoc.class)
        .configureEach(
            task -> {
              StandardJavadocDocletOptions options =
                  (StandardJavadocDocletOptions) task.getOptions();
              options.setEncoding("UTF-8");
              options.noTimestamp(true);
              options.addBooleanOption("Xdoclint:all,-missing", true);
              options.quiet();
            });
    project
        .getTasks()
        .withType(AbstractArchiveTask.class)
        .configureEach(
            task -> {
              task.setPreserveFileTimestamps(false);
              task.setReproducibleFileOrder(true);
            });
    project
        .getTasks()
        .withType(Jar.class)
        .configureEach(
            task ->
                task.getManifest()
                    .attributes(
                        Map.of(
                            "Implementation-Title",
                            project.getName(),
                            "Implementation-Version", // discovery answers with it
                            project.getVersion().toString())));
  }

  /** Every module tests with the catalog's bundle "test"; the launcher is what Gradle itself starts tests with. */
  private static void test(Project project) {
    VersionCatalog catalog =
        project.getExtensions().getByType(VersionCatalogsExtension.class).named("libs");
    project
        .getDependencies()
        .addProvider(
            JavaPlugin.TEST_IMPLEMENTATION_CONFIGURATION_NAME,
            catalog.findBundle("test").orElseThrow());
    project
        .getDependencies()
        .addProvider(
            JavaPlugin.TEST_RUNTIME_ONLY_CONFIGURATION_NAME,
            catalog.findLibrary("junit-platform-launcher").orElseThrow());
    // The test kit has annotations of JUnit's; who uses it has JUnit already.
    project
        .getPluginManager()
        .withPlugin(
            "java-test-fixtures",
            fixtures ->
                project
                    .getDependencies()
                    .addProvider(
                        "testFixturesCompileOnly", catalog.findBundle("test").orElseThrow()));
    Provider<String> excluded =
        project.getProviders().gradleProperty("u2sa.excluded.tags").orElse(EXCLUDED_TAGS);
    project
        .getTasks()
        .withType(Test.class)
        .configureEach(
            task -> {
              String[] tags =
                  Arrays.stream(excluded.get().split(","))
                      .filter(tag -> !tag.isBlank())
                      .toArray(String[]::new);
              task.useJUnitPlatform(platform -> platform.excludeTags(tags));
              TEST_CLASSES.forEach(name -> task.include(name + ".class"));
              task.setMaxParallelForks(TEST_FORKS);
              task.jvmArgs(List.of(TEST_JVM.split(" ")));
              task.setMaxHeapSize("1g");
              // Instead of ~/.u2sa/run: tests do not touch the account's real folders.
              task.environment(
                  "U2SA_ACCOUNT_FOLDER",
                  project.getLayout().getBuildDirectory().dir("account").get().getAsFile().getPath());
            });
  }

  private static void publish(Project project) {
    project
        .getExtensions()
        .getByType(PublishingExtension.class)
        .getPublications()
        .create(
            "maven",
            MavenPublication.class,
            publication -> {
              publication.from(project.getComponents().getByName("java"));
              // Maven has no word for test fixtures; they are published as a jar with that classifier.
              publication.suppressPomMetadataWarningsFor("testFixturesApiElements");
              publication.suppressPomMetadataWarningsFor("testFixturesRuntimeElements");
              publication.pom(pom -> describe(project, pom));
            });
  }

  private static void describe(Project project, MavenPom pom) {
    pom.getName().set(project.getName());
    pom.getDescription().set(project.getProviders().provider(project::getDescription));
    pom.licenses(
        licenses ->
            licenses.license(
                license -> {
                  license.getName().set("Apache-2.0");
                  license.getUrl().set("https://www.apache.org/licenses/LICENSE-2.0.txt");
                }));
  }
}
