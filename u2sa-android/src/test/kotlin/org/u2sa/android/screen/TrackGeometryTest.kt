package org.u2sa.android.screen

import org.assertj.core.api.Assertions.assertThat
import org.assertj.core.data.Offset.offset
import org.junit.jupiter.api.Test
import org.u2sa.android.vehicle.VehicleSnapshot
import org.u2sa.messages.frame.Geodetic
import org.u2sa.messages.frame.Point

class TrackGeometryTest {
    private val here = Geodetic(-81.05, 29.19, 0.0)

    private fun geometry(vararg places: Geodetic) = TrackGeometry(VehicleSnapshot(track = places.toList()), 400.0, 300.0, 20.0)

    private fun place(east: Double, north: Double) = here.fromEnu(Point.of(east, north, 0.0))

    @Test
    fun pixels_oneHundredMetresNorth_isFurtherUpAndInTheMiddle() {
        val geometry = geometry(here, place(0.0, 100.0))

        assertThat(geometry.pixels(here).second).isCloseTo(280f, offset(0.5f))
        assertThat(geometry.pixels(place(0.0, 100.0)).second).isCloseTo(20f, offset(0.5f))
        assertThat(geometry.pixels(here).first).isCloseTo(200f, offset(0.5f))
    }

    @Test
    fun pixels_east_isToTheRightAtTheSameScale() {
        val geometry = geometry(here, place(0.0, 100.0))

        assertThat(geometry.pixels(place(10.0, 0.0)).first - geometry.pixels(here).first).isCloseTo(26f, offset(0.1f))
        assertThat(geometry.pixelsPerMetre).isCloseTo(2.6, offset(0.01))
    }

    @Test
    fun pixelsPerMetre_vehicleThatNeverMoved_doesNotShowItsNoise() {
        assertThat(geometry(here).pixelsPerMetre).isCloseTo(13.0, offset(1e-6)) // 20 m over 260 pixels
    }

    @Test
    fun pixels_placesOfTrackGoalsAndVehicle_areAllInThePicture() {
        val snapshot = VehicleSnapshot(
            track = listOf(here),
            goals = listOf(VehicleSnapshot.Goal("far", place(500.0, -300.0), true)),
            motion = VehicleSnapshot.Motion(place(-40.0, 90.0), null, null, null, 0.0),
        )
        val geometry = TrackGeometry(snapshot, 400.0, 300.0, 20.0)
        for (each in listOf(here, place(500.0, -300.0), place(-40.0, 90.0))) {
            assertThat(geometry.pixels(each).first).isBetween(19.9f, 380.1f)
            assertThat(geometry.pixels(each).second).isBetween(19.9f, 280.1f)
        }
    }

    @Test
    fun scaleBarM_isARoundNumberThatFits() {
        val geometry = geometry(here, place(0.0, 100.0))
        assertThat(geometry.scaleBarM()).isEqualTo(20.0) // 0.3 · 400 / 2.6 = 46 m at most
    }

    @Test
    fun isEmpty_nothingKnown_isTrue() = assertThat(geometry().isEmpty).isTrue()
}
