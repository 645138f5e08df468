package org.u2sa.android.text

import java.io.File
import javax.xml.parsers.DocumentBuilderFactory
import org.assertj.core.api.Assertions.assertThat
import org.junit.jupiter.api.Test

/** Resources are looked up by name, so a name that is not there would show on a phone only: here it shows before. */
class TextTest {
    private val strings: Map<String, String> by lazy {
        val list = DocumentBuilderFactory.newInstance().newDocumentBuilder()
            .parse(File("src/main/res/values/strings.xml")).getElementsByTagName("string")
        (0 until list.length).associate {
            list.item(it).attributes.getNamedItem("name").nodeValue to list.item(it).textContent
        }
    }

    @Test
    fun keys_areThoseOfTheFile() {
        assertThat(Text.entries.map(Text::key)).containsExactlyInAnyOrderElementsOf(strings.keys)
    }

    @Test
    fun strings_canBeFormatted() {
        for ((name, text) in strings) {
            val places = Regex("%(\\d)\\$").findAll(text).map { it.groupValues[1].toInt() }.toSet()
            assertThat(places).describedAs(name).isEqualTo((1..places.size).toSet())
            assertThat(text.replace(Regex("%(\\d\\$[0-9.]*[sdf]|%)"), "")).describedAs(name).doesNotContain("%")
        }
    }

    @Test
    fun drawables_namedInTheSources_areThere() {
        val named = File("src/main/kotlin").walkTopDown().filter(File::isFile)
            .flatMap { Regex("\"(\\w+)\", \"drawable\"").findAll(it.readText()).map { match -> match.groupValues[1] } }.toList()
        assertThat(named).isNotEmpty().allMatch { File("src/main/res/drawable/$it.xml").isFile }
    }
}
