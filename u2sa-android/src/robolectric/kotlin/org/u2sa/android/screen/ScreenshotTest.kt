package org.u2sa.android.screen

import android.app.Activity
import android.graphics.Bitmap
import android.graphics.Canvas
import android.view.View
import java.io.File
import kotlin.math.cos
import kotlin.math.sin
import org.assertj.core.api.Assertions.assertThat
import org.junit.Before
import org.junit.Test
import org.junit.runner.RunWith
import org.robolectric.Robolectric
import org.robolectric.RobolectricTestRunner
import org.robolectric.RuntimeEnvironment
import org.robolectric.annotation.Config
import org.robolectric.annotation.GraphicsMode
import org.u2sa.android.MainActivity
import org.u2sa.android.OnPhone
import org.u2sa.android.vehicle.VehicleHost
import org.u2sa.android.vehicle.VehicleSnapshot
import org.u2sa.messages.safety.FailsafeAction
import org.u2sa.messages.frame.Geodetic
import org.u2sa.messages.frame.Point

/** Draws each screen as a phone would, with Android's own graphics: into target/screens, from where docs/images has them. */
@RunWith(RobolectricTestRunner::class)
@Config(sdk = [35], qualifiers = "w411dp-h891dp-xhdpi")
@GraphicsMode(GraphicsMode.Mode.NATIVE)
class ScreenshotTest {
    private val phone = OnPhone()
    private val home = Geodetic(-81.05, 29.19, 0.0)
    private val folder = File("target/screens").apply { mkdirs() }

    @Before
    fun service() {
        phone.createService()
    }

    private fun place(east: Double, north: Double) = home.fromEnu(Point.of(east, north, 0.0))

    /** Half a round of a loop of six waypoints. */
    private fun driving(): VehicleSnapshot {
        val corners = (0 until 6).map { place(20 * sin(it * Math.PI / 3), 20 * cos(it * Math.PI / 3)) }
        val track = (0..180).map { i ->
            val a = i / 180.0 * 1.45 * Math.PI
            place(20.3 * sin(a) + 0.2 * sin(9 * a), 20.2 * cos(a) + 0.3 * cos(7 * a))
        }
        return VehicleSnapshot(
            armed = true,
            services = listOf("DifferentialControl", "HealthMonitor", "IoioService", "MissionManager", "PathPlanner", "Phone",
                "SafetyManager", "StateEstimator").map { VehicleSnapshot.ServiceLine(it, true, "RUNNING") },
            motion = VehicleSnapshot.Motion(track.last(), 1.45 * Math.PI + 1.5, 1.2, 0.8, 0.05),
            track = track,
            goals = corners.mapIndexed { i, it -> VehicleSnapshot.Goal("${i + 1}", it, i == 5) },
            batteries = mapOf("MAIN" to VehicleSnapshot.Battery(12.3, null), "PHONE" to VehicleSnapshot.Battery(null, 81.0)),
        )
    }

    private fun stopped() = driving().copy(
        armed = false,
        emergency = "Phone: board lost",
        failsafe = FailsafeAction.STOP,
        hazards = listOf(org.u2sa.android.vehicle.PhoneFailsafe.Hazard.BOARD_LOST),
        armingReasons = listOf("emergency stop by \"Phone\": board lost"),
        services = driving().services.map {
            if (it.name == "IoioService") it.copy(healthy = false, words = "STALLED, no data") else it
        },
    )

    private fun panel(name: String, phase: VehicleHost.Phase, snapshot: VehicleSnapshot, trouble: String = "") {
        Robolectric.buildActivity(MainActivity::class.java).setup().use { controller ->
            val panel = Panel(controller.get(), controller.get())
            panel.show(VehicleHost.State(phase), snapshot, trouble, "System shipped/config/ugv/system.xml, mission from the configuration")
            controller.get().setContentView(panel.root)
            draw(controller.get(), name)
        }
    }

    private fun draw(activity: Activity, name: String) {
        phone.idle()
        val view: View = activity.window.decorView
        val bitmap = Bitmap.createBitmap(view.width, view.height, Bitmap.Config.ARGB_8888)
        view.draw(Canvas(bitmap))
        val colours = (0 until bitmap.width step 4).flatMap { x -> (0 until bitmap.height step 4).map { bitmap.getPixel(x, it) } }
        assertThat(colours.distinct()).describedAs("colours of $name").hasSizeGreaterThan(10)
        File(folder, "$name.png").outputStream().use { bitmap.compress(Bitmap.CompressFormat.PNG, 100, it) }
    }

    @Test
    fun driving_light() = panel("phone-driving", VehicleHost.Phase.RUNNING, driving())

    @Test
    fun driving_dark() {
        RuntimeEnvironment.setQualifiers("+night")
        panel("phone-dark", VehicleHost.Phase.RUNNING, driving())
    }

    @Test
    fun driving_sideways() {
        RuntimeEnvironment.setQualifiers("+land")
        panel("phone-landscape", VehicleHost.Phase.RUNNING, driving())
    }

    @Test
    fun emergencyStop_light() =
        panel("phone-stopped", VehicleHost.Phase.RUNNING, stopped(), "the connection broke: socket closed")

    @Test
    fun crashed_light() = panel("phone-crashed", VehicleHost.Phase.CRASHED, VehicleSnapshot())

    @Test
    fun settings_light() {
        phone.allowAll()
        Robolectric.buildActivity(SettingsActivity::class.java).setup().use { draw(it.get(), "phone-settings") }
    }
}
