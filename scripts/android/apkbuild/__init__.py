"""Assembles and signs U2SA's Android application without an Android SDK, and proves what D8 made of it (docs/android-build.md).

Only Python's standard library. Nothing here knows a service or a screen: that is u2sa-android's.
"""
