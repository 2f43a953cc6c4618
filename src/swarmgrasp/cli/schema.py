"""`swarmgrasp schema`: the format of scenario files, for editors."""


def schema() -> None:
    """Print the JSON schema of scenario files, for editors.

    Example: swarmgrasp schema > scenario.schema.json

    Then write this on the first line of a scenario, for editors with a YAML language
    server, and it completes and checks: # yaml-language-server: $schema=scenario.schema.json
    """
    from swarmgrasp.answer_file import document_text
    from swarmgrasp.cli.inputs import print_json
    from swarmgrasp.scenario import scenario_schema

    print_json(document_text(scenario_schema()))
