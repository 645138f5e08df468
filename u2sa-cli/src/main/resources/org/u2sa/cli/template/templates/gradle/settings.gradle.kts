rootProject.name = "{{file}}"
