package org.u2sa.android.vehicle

import java.net.URI
import java.net.http.HttpClient
import java.net.http.HttpRequest
import java.net.http.HttpResponse
import java.net.http.WebSocket
import java.util.concurrent.TimeUnit
import org.assertj.core.api.Assertions.assertThat
import org.junit.After
import org.junit.Test
import org.junit.runner.RunWith
import org.robolectric.RobolectricTestRunner
import org.u2sa.android.OnPhone
import org.u2sa.android.file.VehicleFiles
import org.u2sa.android.file.vehicleFiles
import org.u2sa.testkit.FreePort

/** The operator's page, served by the application. */
@RunWith(RobolectricTestRunner::class)
class StationOnPhoneTest {
    private val phone = OnPhone()
    private val webPort = FreePort.find()
    private val origin = "http://127.0.0.1:$webPort"
    private val browser = HttpClient.newHttpClient()

    @After
    fun close() = phone.close()

    private fun get(path: String) =
        browser.send(HttpRequest.newBuilder(URI("$origin$path")).build(), HttpResponse.BodyHandlers.ofString())

    @Test
    fun web_inTheSystemFile_servesThePageItsFilesAndTheBroker() {
        val services = """
            <system id="ugv">
              <communication configuration="CommunicationManager.xml"/>
              <web port="$webPort"/>
              <service class="org.u2sa.estimation.PassThroughStateEstimator"/>
              <service class="org.u2sa.core.safety.SafetyManager"/>
            </system>
        """.trimIndent()
        val communication = """
            <configuration>
              <variable name="COMMUNICATION MANAGER PORT" type="integer" value="${FreePort.find()}"/>
            </configuration>
        """.trimIndent()
        vehicleFiles(phone.application).import(
            "desk",
            sequenceOf(
                VehicleFiles.Source("system.xml") { services.byteInputStream() },
                VehicleFiles.Source("CommunicationManager.xml") { communication.byteInputStream() },
            ),
        )
        PhoneSettings(phone.application).apply {
            system = "desk/system.xml"
            network = true
        }
        phone.allowAll()
        phone.createService()
        phone.startVehicle()

        val page = get("/")
        assertThat(page.statusCode()).isEqualTo(200)
        val files = Regex("(?:src|href)=\"/?([^\"#:]+)\"").findAll(page.body()).map { it.groupValues[1] }.toList()
        assertThat(files).isNotEmpty()
        assertThat(files + "land.json").allSatisfy { assertThat(get("/$it").statusCode()).`as`(it).isEqualTo(200) }

        val socket = browser.newWebSocketBuilder().header("Origin", origin).subprotocols("mqtt")
            .buildAsync(URI("ws://127.0.0.1:$webPort/mqtt"), object : WebSocket.Listener {})
            .get(30, TimeUnit.SECONDS)
        assertThat(socket.subprotocol).isEqualTo("mqtt")
        socket.abort()
    }
}
