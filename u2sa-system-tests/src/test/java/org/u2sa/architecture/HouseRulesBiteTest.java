package org.u2sa.architecture;

import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import java.io.IOException;
import java.net.URI;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.tools.JavaCompiler;
import javax.tools.JavaFileObject;
import javax.tools.SimpleJavaFileObject;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Each rule of the house refuses a class that was written to break it. */
class HouseRulesBiteTest {
  private static final Pattern PACKAGE = Pattern.compile("package ([\\w.]+);");
  private static final Pattern TYPE = Pattern.compile("(?:class|interface|record|enum) (\\w+)");

  /** What the bad classes lean on, in place of the real ones. */
  private static final List<String> FAR_SIDE =
      List.of(
          "package org.u2sa.messages; public class M {}",
          "package org.u2sa.interfaces; public class I {}",
          "package org.u2sa.service; public class S {}",
          "package org.u2sa.device; public class P {}",
          "package org.u2sa.core; public class C {}",
          "package org.u2sa.core.launch; public class RunningSystem { public static void start() {} }",
          "package org.u2sa.drivers; public class D {}",
          "package org.u2sa.sim; public class X {}",
          "package org.u2sa.gcs; public class G {}",
          "package org.u2sa.flightgear; public class F {}",
          "package org.u2sa.scenarios; public class N {}",
          "package org.u2sa.testkit; public class T {}",
          "package com.fasterxml.jackson.databind; public class ObjectMapper {}",
          "package org.u2sa.spark; public class K {}",
          "package org.apache.spark; public class SparkConf {}",
          "package io.moquette.broker; public class Server {}",
          "package org.eclipse.paho.client; public class Client {}");

  @TempDir Path compiled;

  @ParameterizedTest(name = "{0}: {1}")
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          services repeat         | package org.u2sa.mission; class Bad { double d() { return Math.random(); } }
          services repeat         | package org.u2sa.mission; class Bad { Object r() { return new java.util.Random(); } }
          services repeat         | package org.u2sa.planning.route; class Bad { Object m() { return java.util.Map.of("a", 1, "b", 2); } }
          services repeat         | package org.u2sa.control; class Bad { Object s() { return java.util.Set.copyOf(java.util.List.of(1)); } }
          services repeat         | package org.u2sa.world; class Bad { Object t() { return new Thread(() -> {}); } }
          services repeat         | package org.u2sa.world; class Bad { Object t() { return java.util.List.of(1).parallelStream(); } }
          services repeat         | package org.u2sa.core.safety; class Bad { Object e() { return java.util.concurrent.Executors.newCachedThreadPool(); } }
          arrows of messages      | package org.u2sa.messages; class Bad { org.u2sa.interfaces.I i; }
          arrows of interfaces    | package org.u2sa.interfaces.xml; class Bad { org.u2sa.service.S s; }
          arrows of service       | package org.u2sa.service; class Bad { org.u2sa.core.C c; }
          arrows of service       | package org.u2sa.service; class Bad { org.u2sa.testkit.T t; }
          arrows of service       | package org.u2sa.service; class Bad { org.u2sa.device.P p; }
          arrows of device        | package org.u2sa.device; class Bad { org.u2sa.drivers.D d; }
          arrows of device        | package org.u2sa.device; class Bad { org.u2sa.core.C c; }
          arrows of sim           | package org.u2sa.sim; class Bad { org.u2sa.drivers.D d; }
          arrows of core          | package org.u2sa.core; class Bad { org.u2sa.sim.X x; }
          arrows of core          | package org.u2sa.core; class Bad { org.u2sa.drivers.D d; }
          arrows of core          | package org.u2sa.core.launch; class Bad { Object o = new org.u2sa.gcs.G(); }
          arrows of sim           | package org.u2sa.sim; class Bad extends org.u2sa.drivers.D {}
          arrows of sim           | package org.u2sa.sim; class Bad { org.u2sa.core.C c; }
          arrows of drivers       | package org.u2sa.drivers; class Bad { org.u2sa.sim.X x; }
          arrows of gcs           | package org.u2sa.gcs; class Bad { org.u2sa.flightgear.F f; }
          arrows of flightgear    | package org.u2sa.flightgear; class Bad { org.u2sa.gcs.G g; }
          arrows of gcs           | package org.u2sa.gcs; class Bad { org.u2sa.sim.X x; }
          arrows of gcs           | package org.u2sa.gcs; class Bad { org.u2sa.scenarios.N n; }
          arrows of scenarios     | package org.u2sa.scenarios.ugv; class Bad { org.u2sa.spark.K k; }
          arrows of trials        | package org.u2sa.trials.campaign; class Bad { org.u2sa.scenarios.N n; }
          Spark                   | package org.u2sa.trials.campaign; class Bad { org.apache.spark.SparkConf c; }
          known packages          | package org.u2sa.elsewhere; class Bad {}
          named by subject        | package org.u2sa.core.util; class Bad {}
          named by subject        | package org.u2sa.core.impl.mission; class Bad {}
          Moquette                | package org.u2sa.mission; class Bad { io.moquette.broker.Server s; }
          Paho                    | package org.u2sa.core.communication; class Bad { org.eclipse.paho.client.Client c; }
          one console             | package org.u2sa.core; class Bad { void p() { System.out.println(); } }
          one console             | package org.u2sa.service; class Bad { java.io.PrintStream p = System.err; }
          vehicles do not wait for output | package org.u2sa.cli.run; class Bad { void s() { org.u2sa.core.launch.RunningSystem.start(); } }
          one clock               | package org.u2sa.core; class Bad { long t() { return System.nanoTime(); } }
          one clock               | package org.u2sa.gcs; class Bad { Object t() { return java.time.Instant.now(); } }
          one clock               | package org.u2sa.sim; class Bad { Object t() { return new java.util.Date(); } }
          one clock               | package org.u2sa.sim; class Bad { java.util.function.LongSupplier t = System::currentTimeMillis; }
          no static mutable state | package org.u2sa.core; class Bad { static int count; }
          no static mutable state | package org.u2sa.core; class Bad { static final java.util.Map<String, String> M = java.util.Map.of(); private static String s = ""; }
          no static mutable state | package org.u2sa.core; class Bad { static final java.util.concurrent.atomic.AtomicLong N = new java.util.concurrent.atomic.AtomicLong(); }
          no static mutable state | package org.u2sa.core; class Bad { static final java.util.HashMap<String, String> M = new java.util.HashMap<>(); }
          no Java serialization   | package org.u2sa.messages; class Bad implements java.io.Serializable {}
          no Java serialization   | package org.u2sa.core; class Bad { Object r(java.io.ObjectInputStream i) throws Exception { return i.readObject(); } }
          small circles           | package org.u2sa.messages; class Bad { A a; } class A { B b; } class B { Object c = new C.D(); } class C { static class D { Bad[] d; } }
          small circles           | package org.u2sa.interfaces; class Bad<T extends A> {} class A { B b; } class B { C c; } class C { void d() { new Bad<A>(); } }
          no objects from data    | package org.u2sa.gcs; class Bad { com.fasterxml.jackson.databind.ObjectMapper m; }
          no objects from data    | package org.u2sa.core; class Bad { Object o = new java.beans.XMLDecoder(System.in); }
          one XML reader          | package org.u2sa.mission; class Bad { javax.xml.parsers.SAXParser p; }
          SVG                     | package org.u2sa.gcs; class Bad { org.w3c.dom.Document d; }
          one XML reader          | package org.u2sa.gcs; class Bad { Object f = javax.xml.stream.XMLInputFactory.newFactory(); }
          no Java serialization   | package org.u2sa.core; class Bad { void w(java.io.ObjectOutputStream o) throws Exception { o.writeObject(""); } }
          """)
  void rule_onAClassThatBreaksIt_refusesTheClass(String rule, String source) throws IOException {
    assertThat(violations(rule, compiled(source)))
        .anySatisfy(line -> assertThat(line).contains("Bad"));
  }

  @Test
  void noCircles_onTwoPackagesThatNeedEachOther_refusesThem() throws IOException {
    List<JavaFileObject> sources = new ArrayList<>();
    sources.add(new Source("package org.u2sa.core.one; public class A { org.u2sa.core.two.B b; }"));
    sources.add(new Source("package org.u2sa.core.two; public class B { org.u2sa.core.one.A a; }"));
    assertThat(violations("no circles between packages", compiled(sources)))
        .anySatisfy(line -> assertThat(line).contains("core.one").contains("core.two"));
  }

  @Test
  void noCirclesBetweenClasses_onTwoServiceClassesThatNeedEachOther_refusesThem()
      throws IOException {
    List<JavaFileObject> sources = new ArrayList<>();
    sources.add(new Source("package org.u2sa.service; class Part { Whole.Piece piece; }"));
    sources.add(
        new Source("package org.u2sa.service; class Whole { Part part; static class Piece {} }"));
    assertThat(violations("no circles between service classes", compiled(sources)))
        .anySatisfy(line -> assertThat(line).contains("service.Part").contains("service.Whole"));
  }

  @Test
  void smallPackages_onOneOfMoreThanThirtyClasses_refusesIt() throws IOException {
    List<JavaFileObject> sources = new ArrayList<>();
    for (int i = 0; i < 31; i++) {
      sources.add(
          new Source("package org.u2sa.mission; class Part" + i + " { static class Piece {} }"));
    }
    assertThat(violations("small packages", compiled(sources.subList(0, 30)))).isEmpty();
    assertThat(violations("small packages", compiled(sources)))
        .anySatisfy(line -> assertThat(line).contains("Part30").contains("31 classes"));
  }

  @Test
  void classCircles_ofThreeClasses_areAccepted() throws IOException {
    String three =
        "package org.u2sa.messages; class A { B b; C c; } class B { C c; } class C { A a; }";
    assertThat(violations("small circles", compiled(three))).isEmpty();
  }

  @Test
  void rules_onAClassThatKeepsThem_accept() throws IOException {
    String good =
        """
        package org.u2sa.core.communication;

        class Good extends RuntimeException {
          enum Phase { A, B }
          private static final java.util.List<String> NAMES = java.util.List.of("a");
          private static final double[] TABLE = {1.0};
          private io.moquette.broker.Server server;
          int of(Phase phase) { assert phase != null; return switch (phase) { case A -> 1; case B -> 2; }; }
          java.time.Instant at(long s) { return java.time.Instant.ofEpochSecond(s); }
        }
        """;
    JavaClasses classes = compiled(good);
    for (String rule : HouseRules.all().keySet()) {
      assertThat(violations(rule, classes)).as(rule).isEmpty();
    }
  }

  private static List<String> violations(String rule, JavaClasses classes) {
    return HouseRules.all().get(rule).evaluate(classes).getFailureReport().getDetails();
  }

  private JavaClasses compiled(String source) throws IOException {
    List<JavaFileObject> sources = new ArrayList<>();
    FAR_SIDE.forEach(text -> sources.add(new Source(text)));
    sources.add(new Source(source));
    return compiled(sources);
  }

  private JavaClasses compiled(List<JavaFileObject> sources) {
    JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
    List<String> options =
        List.of("-proc:none", "-d", compiled.toString(), "-cp", compiled.toString());
    assertThat(compiler.getTask(null, null, null, options, null, sources).call()).isTrue();
    return new ClassFileImporter().importPath(compiled.resolve("org/u2sa"));
  }

  private static final class Source extends SimpleJavaFileObject {
    private final String text;

    Source(String text) {
      super(
          URI.create(
              "string:///"
                  + found(PACKAGE, text).replace('.', '/')
                  + "/"
                  + found(TYPE, text)
                  + ".java"),
          Kind.SOURCE);
      this.text = text;
    }

    @Override
    public CharSequence getCharContent(boolean ignoreEncodingErrors) {
      return text;
    }

    private static String found(Pattern pattern, String text) {
      Matcher matcher = pattern.matcher(text);
      assertThat(matcher.find()).as(text).isTrue();
      return matcher.group(1);
    }
  }
}
